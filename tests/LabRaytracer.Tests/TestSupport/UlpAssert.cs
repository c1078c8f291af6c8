namespace LabRaytracer.Tests;

/// <summary>Comparison of numbers in units in the last place.</summary>
internal static class UlpAssert
{
    /// <summary>Distance to the next number away from zero: one ulp of the format at a magnitude.</summary>
    public static double Ulp(double value, bool single)
    {
        double size = Math.Abs(value);
        return single ? MathF.BitIncrement((float)size) - (double)(float)size : Math.BitIncrement(size) - size;
    }

    /// <summary>Error in ulp against a number and what the exact result has more than it.</summary>
    public static double Error(double actual, double nearest, double rest, bool single) =>
        Math.Abs(((actual - nearest) / Ulp(nearest, single)) - rest);

    /// <summary>Fails unless two doubles differ by at most a number of ulp.</summary>
    public static void Within(double ulps, double expected, double actual)
    {
        double error = Error(actual, expected, 0, false);
        Assert.True(error <= ulps, $"Expected {expected:R}, got {actual:R}: {error} ulp apart, allowed {ulps}.");
    }

    /// <summary>Fails unless two doubles have the same bits.</summary>
    public static void SameBits(double expected, double actual) =>
        Assert.True(BitConverter.DoubleToInt64Bits(expected) == BitConverter.DoubleToInt64Bits(actual), $"Expected the bits of {expected:R}, got {actual:R}.");
}
