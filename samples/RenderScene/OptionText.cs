using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>Values of options, from text.</summary>
internal static class OptionText
{
    /// <summary>A whole number in a range.</summary>
    public static int Integer(string name, string text, int min, int max) =>
        int.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int value) && value >= min && value <= max
            ? value
            : throw new UsageException(string.Create(CultureInfo.InvariantCulture, $"{name} '{text}' is not a whole number from {min} to {max}."));

    /// <summary>A finite number that is at least 0.</summary>
    public static double NotNegative(string name, string text) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && value >= 0 && double.IsFinite(value)
            ? value
            : throw new UsageException($"{name} '{text}' is not a number of at least 0, such as 0.01.");

    /// <summary>A number in a range.</summary>
    public static double Number(string name, string text, double min, double max) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && value >= min && value <= max
            ? value
            : throw new UsageException(string.Create(CultureInfo.InvariantCulture, $"{name} '{text}' is not a number from {min} to {max}."));

    /// <summary>Whole numbers with a separator between them, such as 1280x720.</summary>
    public static int[] Integers(string name, string text, char separator, string form)
    {
        string[] parts = text.Split(separator);
        int[] values = new int[form.Split(separator).Length];
        bool isGood = parts.Length == values.Length;
        for (int i = 0; i < values.Length && isGood; i++)
        {
            isGood = int.TryParse(parts[i], NumberStyles.None, CultureInfo.InvariantCulture, out values[i]);
        }

        return isGood ? values : throw new UsageException($"{name} '{text}' is not of the form {form}, in whole numbers of pixels.");
    }

    /// <summary>One of some words; case does not matter.</summary>
    public static T Word<T>(string name, string text, IReadOnlyDictionary<string, T> words) =>
        words.TryGetValue(text.ToLowerInvariant(), out T? value)
            ? value
            : throw new UsageException($"{name} '{text}' is not known{Wording.Suggestion(text, words.Keys)}; allowed: {string.Join(", ", words.Keys)}.");
}
