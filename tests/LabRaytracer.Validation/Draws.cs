namespace LabRaytracer.Validation;

/// <summary>Random numbers of a seed: the same on every machine.</summary>
/// <remarks>SplitMix64: Steele, Lea, Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.</remarks>
internal sealed class Draws(ulong seed)
{
    private ulong _state = seed;

    /// <summary>Another stream of the same seed, for a part of a sweep.</summary>
    public static Draws Of(ulong seed, string sweep, int part)
    {
        ulong hash = 14695981039346656037;
        foreach (char c in sweep)
        {
            hash = (hash ^ c) * 1099511628211;
        }

        return new Draws(new Draws(seed ^ hash).Next() + (ulong)part);
    }

    /// <summary>64 random bits.</summary>
    public ulong Next()
    {
        _state += 0x9E3779B97F4A7C15;
        ulong z = (_state ^ (_state >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return z ^ (z >> 31);
    }

    /// <summary>A whole number in [0, end).</summary>
    public int Integer(int end) => (int)(Next() % (ulong)end);

    /// <summary>A number in [from, to).</summary>
    public double Number(double from = 0, double to = 1) => from + ((to - from) * (Next() >> 11) * 1.1102230246251565e-16);

    /// <summary>10 to a uniformly distributed power.</summary>
    public double Scale(double fromPower, double toPower) => Math.Pow(10, Number(fromPower, toPower));

    /// <summary>1 or -1.</summary>
    public int Sign() => (Next() & 1) == 0 ? 1 : -1;

    /// <summary>A direction, length 1 up to rounding, evenly distributed.</summary>
    public Vector3D Direction()
    {
        while (true)
        {
            Vector3D v = new(Number(-1, 1), Number(-1, 1), Number(-1, 1));
            if (v.Length is > 0.01 and < 1)
            {
                return v.Normalized();
            }
        }
    }

    /// <summary>A direction perpendicular to another, up to rounding.</summary>
    public Vector3D Across(Vector3D direction) => Vector3D.Cross(direction, Vector3D.Cross(Direction(), direction)).Normalized();
}
