namespace LabRaytracer.Validation;

/// <summary>Angles of the oracle in pairs of doubles: a hundred times as quick as <see cref="Truth"/>, within 2^-90 of it.</summary>
/// <remarks>
/// Long sweeps measure with it and ask <see cref="Truth"/> where an error is large, where a range limit is near, and at every 1009th input, to see that both agree.
/// </remarks>
internal static class QuickTruth
{
    private const int Slots = 64;

    /// <summary>A part of a quotient below this would have underflowed.</summary>
    private const double Least = 1e-250;

    private static readonly Pair s_turnsPerRadian = Pair.Of(Truth.TurnsPerRadian);
    private static readonly Pair[] s_arctan = [.. Enumerable.Range(0, Slots + 1).Select(slot => Pair.Of(Truth.ArctanOfSlot(slot)))];
    private static readonly Pair[] s_odd = [.. Enumerable.Range(0, 8).Select(n => Pair.Of((Real)(n % 2 == 0 ? 1 : -1) / ((2 * n) + 1)))];

    /// <summary>Angle of (y, x) in turns, [0, 1).</summary>
    /// <returns>False if the numbers are out of the range of the quick form.</returns>
    public static bool TryAtan2Turns(Pair y, Pair x, out Pair turns)
    {
        turns = 0;
        if (y.High == 0 && x.High == 0)
        {
            return true;
        }

        Pair ay = y.High < 0 ? -y : y, ax = x.High < 0 ? -x : x;
        bool isSteep = ay.High > ax.High || (ay.High == ax.High && ay.Low > ax.Low);
        (Pair small, Pair large) = isSteep ? (ax, ay) : (ay, ax);
        int power = -Math.ILogB(large.High);
        bool isZero = small.High == 0;
        (small, large) = (small.Scaled(power), large.Scaled(power));
        if (!isZero && small.High < Least)
        {
            return false;
        }

        turns = Arctan(small / large) * s_turnsPerRadian;
        turns = isSteep ? 0.25 - turns : turns;
        turns = x.High < 0 ? 0.5 - turns : turns;
        turns = y.High < 0 && turns.High != 0 ? 1 - turns : turns;
        return true;
    }

    /// <summary>sqrt(x² + z²) as a pair times a power of two.</summary>
    public static Pair Hypotenuse(double x, double z, out int power)
    {
        double larger = Math.Max(Math.Abs(x), Math.Abs(z));
        power = larger == 0 ? 0 : Math.ILogB(larger);
        Pair a = Math.ScaleB(x, -power), b = Math.ScaleB(z, -power);
        return larger == 0 ? 0 : Pair.Sqrt((a * a) + (b * b));
    }

    /// <summary>(u, v) of the spherical mapping.</summary>
    /// <returns>False if the numbers are out of the range of the quick form.</returns>
    public static bool TrySphere(double x, double y, double z, out Pair u, out Pair v)
    {
        v = 0.5;
        Pair radius = Hypotenuse(x, z, out int power);
        if (!IsWhole(x) || !IsWhole(y) || !IsWhole(z) || !TryAtan2Turns(x, z, out u))
        {
            u = 0;
            return false;
        }

        if (radius.High == 0 && y == 0)
        {
            return true;
        }

        // The height is brought to the radius' scale, if it is not too far away.
        int height = y == 0 ? power : Math.ILogB(y);
        if (Math.Abs(height - power) > 800 || !TryAtan2Turns(radius, Math.ScaleB(-y, -power), out v))
        {
            return false;
        }

        v = v.Scaled(1);
        return true;
    }

    /// <summary>(u, v) of the cylindrical mapping.</summary>
    /// <returns>False if the numbers are out of the range of the quick form.</returns>
    public static bool TryCylinder(double x, double y, double z, out Pair u, out Pair v)
    {
        v = Pair.Sum(y, 1).Scaled(-1);
        u = 0;
        return IsWhole(x) && IsWhole(y) && IsWhole(z) && TryAtan2Turns(x, z, out u);
    }

    /// <summary>(u, v) of the disk mapping.</summary>
    /// <returns>False if the numbers are out of the range of the quick form.</returns>
    public static bool TryDisk(double x, double y, double z, out Pair u, out Pair v)
    {
        v = Hypotenuse(x, z, out int power).Scaled(power);
        u = 0;
        return IsWhole(x) && IsWhole(z) && Math.Abs(power) < 800 && TryAtan2Turns(x, z, out u);
    }

    /// <summary>(u, v) of the rectangular mapping.</summary>
    /// <returns>False if the numbers are out of the range of the quick form.</returns>
    public static bool TryRectangle(double x, double y, double z, out Pair u, out Pair v)
    {
        (u, v) = (Pair.Sum(z, 1).Scaled(-1), Pair.Sum(x, 1).Scaled(-1));
        return IsWhole(x) && IsWhole(z);
    }

    /// <summary>(u, v) of the hemispherical mapping.</summary>
    /// <returns>False if the numbers are out of the range of the quick form.</returns>
    public static bool TryHemisphere(double x, double y, double z, out Pair u, out Pair v)
    {
        bool isSure = TrySphere(x, y > 0 ? y : 0, z, out u, out _);
        Pair radius = Hypotenuse(x, z, out int power);
        v = 0;
        isSure = isSure && (y <= 0 || TryAtan2Turns(Math.ScaleB(y, -power), radius, out v));
        v = v.Scaled(2);
        return isSure;
    }

    /// <summary>(u, v) of the box mapping on the face whose normal is (z, x, y).</summary>
    /// <returns>False if the numbers are out of the range of the quick form.</returns>
    public static bool TryBox(double x, double y, double z, out Pair u, out Pair v)
    {
        double ax = Math.Abs(x), ay = Math.Abs(y), az = Math.Abs(z);
        bool isOnX = az >= ax && az >= ay, isOnY = !isOnX && ax >= ay;
        double right = isOnX ? (z < 0 ? z : -z) : isOnY || y >= 0 ? x : -x, up = isOnY ? (x < 0 ? z : -z) : y;
        (u, v) = (Pair.Sum(right, 1).Scaled(-1), Pair.Sum(up, 1).Scaled(-1));
        return IsWhole(x) && IsWhole(y) && IsWhole(z);
    }

    /// <summary>False for subnormal numbers, whose scaling would have to be looked at.</summary>
    private static bool IsWhole(double a) => a == 0 || Math.Abs(a) >= 1e-300;

    private static Pair Arctan(Pair quotient)
    {
        int slot = (int)((quotient.High * Slots) + 0.5);
        Pair near = (double)slot / Slots, rest = slot == 0 ? quotient : (quotient - near) / (1 + (quotient * near));
        Pair square = rest * rest, sum = s_odd[^1];
        for (int n = s_odd.Length - 2; n >= 0; n--)
        {
            sum = s_odd[n] + (square * sum);
        }

        return s_arctan[slot] + (rest * sum);
    }
}
