namespace LabRaytracer;

/// <summary>Bit patterns that turn an exponent field into a number and back without integer conversion.</summary>
/// <remarks>An integer n below 2^52 in the significand field of 2^52 is the double 2^52 + n; likewise 2^23 for floats.</remarks>
internal static class LaneBits
{
    /// <summary>Bits of the double 2^52.</summary>
    public const long Double52 = 0x4330_0000_0000_0000;

    /// <summary>2^52 plus the exponent bias of doubles.</summary>
    public const double Double52Bias = 4503599627370496.0 + 1023;

    /// <summary>Bits of the float 2^23.</summary>
    public const int Single23 = 0x4B00_0000;

    /// <summary>2^23 plus the exponent bias of floats.</summary>
    public const float Single23Bias = 8388608f + 127;
}
