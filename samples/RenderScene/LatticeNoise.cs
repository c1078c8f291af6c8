namespace RenderScene;

/// <summary>Repeatable smooth noise for pictures: the same numbers on every machine.</summary>
internal static class LatticeNoise
{
    /// <summary>A random number of a lattice point, [0, 1).</summary>
    public static float At(int x, int y, uint seed)
    {
        unchecked
        {
            uint hash = ((uint)x * 0x8DA6B343u) ^ ((uint)y * 0xD8163841u) ^ (seed * 0xCB1AB31Fu);
            hash = (hash ^ (hash >> 16)) * 0x7FEB352Du;
            hash = (hash ^ (hash >> 15)) * 0x846CA68Bu;
            return ((hash ^ (hash >> 16)) >> 8) * (1f / (1 << 24));
        }
    }

    /// <summary>Smooth noise over a lattice that closes at its sides, [0, 1].</summary>
    /// <param name="u">Place along the columns, at least 0; the noise has period 1.</param>
    /// <param name="v">Place along the rows, at least 0; the noise has period 1.</param>
    /// <param name="columns">Lattice points along u.</param>
    /// <param name="rows">Lattice points along v.</param>
    /// <param name="seed">Which noise.</param>
    public static float Smooth(float u, float v, int columns, int rows, uint seed)
    {
        float x = u * columns, y = v * rows;
        int left = (int)x, below = (int)y;
        float right = Ease(x - left), above = Ease(y - below);
        int x0 = left % columns, x1 = (left + 1) % columns, y0 = below % rows, y1 = (below + 1) % rows;
        float low = Between(At(x0, y0, seed), At(x1, y0, seed), right);
        float high = Between(At(x0, y1, seed), At(x1, y1, seed), right);
        return Between(low, high, above);
    }

    /// <summary>Noise of several sizes, each half as large and half as strong as the one before, [0, 1].</summary>
    /// <param name="u">Place along the columns, at least 0; the noise has period 1.</param>
    /// <param name="v">Place along the rows, at least 0; the noise has period 1.</param>
    /// <param name="columns">Lattice points of the coarsest noise along u.</param>
    /// <param name="rows">Lattice points of the coarsest noise along v.</param>
    /// <param name="seed">Which noise.</param>
    public static float Fractal(float u, float v, int columns, int rows, uint seed)
    {
        float sum = 0, weight = 0.5f;
        for (int octave = 0; octave < 5; octave++)
        {
            sum += weight * Smooth(u, v, columns << octave, rows << octave, seed + (uint)octave);
            weight /= 2;
        }

        return sum / 0.96875f;
    }

    private static float Ease(float t) => t * t * (3 - (2 * t));

    private static float Between(float a, float b, float weight) => a + ((b - a) * weight);
}
