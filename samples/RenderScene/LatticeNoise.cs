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
    /// <param name="x">Place along x, lattice units, [0, columns].</param>
    /// <param name="y">Place along y, lattice units, at least 0.</param>
    /// <param name="columns">Lattice points after which the noise repeats along x.</param>
    /// <param name="seed">Which noise.</param>
    public static float Smooth(float x, float y, int columns, uint seed)
    {
        int left = (int)x, below = (int)y;
        float right = Ease(x - left), above = Ease(y - below);
        int x0 = left % columns, x1 = (left + 1) % columns;
        float low = Between(At(x0, below, seed), At(x1, below, seed), right);
        float high = Between(At(x0, below + 1, seed), At(x1, below + 1, seed), right);
        return Between(low, high, above);
    }

    /// <summary>Noise of several sizes, each half as large and half as strong as the one before, [0, 1].</summary>
    /// <param name="u">Place, [0, 1]; the noise closes at its ends.</param>
    /// <param name="v">Place, at least 0.</param>
    /// <param name="columns">Lattice points of the coarsest noise along u.</param>
    /// <param name="rows">Lattice points of the coarsest noise along v from 0 to 1.</param>
    /// <param name="seed">Which noise.</param>
    public static float Fractal(float u, float v, int columns, int rows, uint seed)
    {
        float sum = 0, weight = 0.5f;
        for (int octave = 0; octave < 5; octave++)
        {
            int cells = columns << octave;
            sum += weight * Smooth(u * cells, v * (rows << octave), cells, seed + (uint)octave);
            weight /= 2;
        }

        return sum / 0.96875f;
    }

    private static float Ease(float t) => t * t * (3 - (2 * t));

    private static float Between(float a, float b, float weight) => a + ((b - a) * weight);
}
