namespace LabRaytracer.Benchmarks;

/// <summary>Sines and roots of 28 digits, for error columns.</summary>
internal static class DecimalAngles
{
    public const decimal Tau = 6.2831853071795864769252867666m;

    /// <summary>A double of ordinary size without the 15-digit rounding of the cast.</summary>
    public static decimal Exact(double number)
    {
        if (number == 0)
        {
            return 0;
        }

        int shift = 52 - Math.ILogB(number);
        decimal exact = (long)Math.ScaleB(number, shift);
        for (; shift > 0; shift -= 60)
        {
            exact /= 1L << Math.Min(shift, 60);
        }

        return exact;
    }

    public static decimal Sqrt(decimal number)
    {
        decimal root = (decimal)Math.Sqrt((double)number);
        root = (root + (number / root)) / 2;
        return (root + (number / root)) / 2;
    }

    public static (decimal Sin, decimal Cos) SinCos(decimal angle)
    {
        // Taylor series of an eighth of the angle, then three doublings.
        decimal x = angle / 8, term = 1, sin = 0, cos = 1;
        for (int k = 1; k < 26; k++)
        {
            term *= x / k;
            (sin, cos) = k % 2 == 1 ? (sin + (k % 4 == 1 ? term : -term), cos) : (sin, cos + (k % 4 == 0 ? term : -term));
        }

        for (int i = 0; i < 3; i++)
        {
            (sin, cos) = (2 * sin * cos, (cos * cos) - (sin * sin));
        }

        return (sin, cos);
    }
}
