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

    /// <summary>The value, if it is a finite number above 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not.</exception>
    public static double Positive(double value, string what) => value > 0 && double.IsFinite(value)
        ? value
        : throw new ArgumentOutOfRangeException(nameof(value), value, $"The {what} must be finite and above 0.");

    /// <summary>The value, if it is a finite number.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not.</exception>
    public static double Finite(double value, string what) => double.IsFinite(value)
        ? value
        : throw new ArgumentOutOfRangeException(nameof(value), value, $"The {what} must be finite.");

    /// <summary>The value, if it lies in [0, 1].</summary>
    /// <exception cref="ArgumentOutOfRangeException">It does not.</exception>
    public static double Share(double value, string what) => value is >= 0 and <= 1
        ? value
        : throw new ArgumentOutOfRangeException(nameof(value), value, $"The {what} must be in [0, 1].");

    /// <summary>The value, if it is the width of a filter.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not.</exception>
    public static double FilterWidth(double value) => value is >= 0 and <= 16
        ? value
        : throw new ArgumentOutOfRangeException(nameof(value), value, "The filter width of a texture must be in [0, 16] footprints.");

    /// <summary>The value, if it is finite and not below 0.</summary>
    /// <exception cref="ArgumentOutOfRangeException">It is not.</exception>
    public static double NotNegative(double value, string what) => value >= 0 && double.IsFinite(value)
        ? value
        : throw new ArgumentOutOfRangeException(nameof(value), value, $"The {what} must be finite and not below 0.");
}
