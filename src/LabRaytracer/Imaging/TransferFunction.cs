using System.Globalization;

namespace LabRaytracer;

/// <summary>What a stored sample means as light: sRGB, linear, or a power of the sample.</summary>
/// <remarks>Immutable, thread safe. The default value is <see cref="Srgb"/>. Alpha is always linear, whatever the transfer function.</remarks>
public readonly record struct TransferFunction
{
    /// <summary>Smallest exponent that <see cref="Gamma"/> takes.</summary>
    public const double MinExponent = 0.2;

    /// <summary>Largest exponent that <see cref="Gamma"/> takes.</summary>
    public const double MaxExponent = 5;

    // 0 stands for the piecewise sRGB curve, so that the default value is the usual one.
    private readonly double exponent;

    private TransferFunction(double exponent) => this.exponent = exponent;

    /// <summary>The piecewise curve of IEC 61966-2-1 (sRGB).</summary>
    public static TransferFunction Srgb => default;

    /// <summary>The sample is proportional to light.</summary>
    public static TransferFunction Linear => new(1);

    /// <summary>Tells whether this is the piecewise sRGB curve.</summary>
    public bool IsSrgb => exponent == 0;

    /// <summary>Tells whether the sample is proportional to light.</summary>
    public bool IsLinear => exponent == 1;

    /// <summary>Exponent e of light = sample^e; 1 for <see cref="Linear"/>, NaN for <see cref="Srgb"/>, which is no power.</summary>
    public double Exponent => IsSrgb ? double.NaN : exponent;

    /// <summary>Light = sample^<paramref name="exponent"/>, for example 2.2.</summary>
    /// <param name="exponent">In [0.2, 5], ends included.</param>
    /// <exception cref="ArgumentOutOfRangeException">The exponent is outside of that range or NaN.</exception>
    public static TransferFunction Gamma(double exponent)
    {
        if (!(exponent >= MinExponent && exponent <= MaxExponent))
        {
            throw new ArgumentOutOfRangeException(
                nameof(exponent),
                exponent,
                "The exponent of a gamma transfer function must be in [0.2, 5]; 2.2 is usual.");
        }

        return new TransferFunction(exponent);
    }

    /// <summary>Light of an encoded value.</summary>
    /// <param name="encoded">Sample scaled to [0, 1]; below 0 and NaN give 0; above 1 the curve goes on.</param>
    /// <returns>Linear light, 0 or more; within 2 ulp of the exact value, the same bits on every machine.</returns>
    public double Decode(double encoded)
    {
        if (!(encoded > 0))
        {
            return 0;
        }

        if (IsSrgb)
        {
            // IEC 61966-2-1, section 5.2: the straight part ends at 0.04045.
            return encoded <= 0.04045 ? encoded / 12.92 : PortablePower.Pow((encoded + 0.055) / 1.055, 2.4);
        }

        return IsLinear ? encoded : PortablePower.Pow(encoded, exponent);
    }

    /// <summary>Encoded value of light: the inverse of <see cref="Decode"/>, not rounded to a code.</summary>
    /// <param name="light">Linear light; below 0 and NaN give 0; above 1 the curve goes on.</param>
    /// <returns>Sample scaled so that 1 is display white; 0 or more.</returns>
    public double Encode(double light)
    {
        if (!(light > 0))
        {
            return 0;
        }

        if (IsSrgb)
        {
            return light <= 0.0031308 ? light * 12.92 : (1.055 * PortablePower.Pow(light, 1 / 2.4)) - 0.055;
        }

        return IsLinear ? light : PortablePower.Pow(light, 1 / exponent);
    }

    /// <summary>"sRGB", "linear" or "gamma 2.2".</summary>
    public override string ToString() => IsSrgb
        ? "sRGB"
        : IsLinear ? "linear" : string.Create(CultureInfo.InvariantCulture, $"gamma {exponent:0.####}");
}
