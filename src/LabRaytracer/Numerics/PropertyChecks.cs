namespace LabRaytracer;

/// <summary>Checks of values that are given to properties.</summary>
internal static class PropertyChecks
{
    /// <summary>The value, if there is one.</summary>
    /// <exception cref="ArgumentNullException">There is none.</exception>
    public static T NotNull<T>(T value)
        where T : class => value ?? throw new ArgumentNullException(nameof(value));

    /// <summary>The value, if its enumeration knows it.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It does not.</exception>
    public static TEnum Known<TEnum>(TEnum value)
        where TEnum : struct, Enum => Enum.IsDefined(value)
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, $"Unknown {typeof(TEnum).Name}. Allowed: {string.Join(", ", Enum.GetNames<TEnum>())}.");
}
