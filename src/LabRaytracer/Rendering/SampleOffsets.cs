using System.Numerics;

namespace LabRaytracer;

/// <summary>Where samples lie in their pixels: from (seed, pixel, sample) alone, so that any pixel can be repeated by itself.</summary>
internal static class SampleOffsets
{
    /// <summary>Position of a sample of an n x n grid along one axis, [0, 1).</summary>
    /// <param name="options">Pattern, number of samples, seed.</param>
    /// <param name="pixelX">Column in the whole picture.</param>
    /// <param name="pixelY">Row in the whole picture.</param>
    /// <param name="sample">Number of the sample.</param>
    /// <param name="axis">0 for x, 1 for y.</param>
    public static double Jittered(RenderOptions options, int pixelX, int pixelY, int sample, int axis)
    {
        int side = Side(options);
        int cell = axis == 0 ? sample % side : sample / side;
        return (cell + ((Hash(options.Seed, pixelX, pixelY, (2 * sample) + axis) >> 11) * (1.0 / (1UL << 53)))) / side;
    }

    /// <summary>Position of a multi-jittered sample of an n x n grid along one axis, [0, 1): inside of its cell in a row (a column) of n² of its own.</summary>
    /// <param name="options">Number of samples, seed.</param>
    /// <param name="pixelX">Column in the whole picture.</param>
    /// <param name="pixelY">Row in the whole picture.</param>
    /// <param name="sample">Number of the sample.</param>
    /// <param name="axis">0 for x, 1 for y.</param>
    public static double MultiJittered(RenderOptions options, int pixelX, int pixelY, int sample, int axis)
    {
        // Cells in one column take different parts of it: which one is a permutation of their rows, another one in each column; likewise the other way around.
        int side = Side(options), cell = axis == 0 ? sample % side : sample / side, other = axis == 0 ? sample / side : sample % side;
        uint key = (uint)(Hash(options.Seed, pixelX, pixelY, -3 - (2 * cell) - axis) >> 32);
        double inside = (Hash(options.Seed, pixelX, pixelY, (2 * sample) + axis) >> 11) * (1.0 / (1UL << 53));
        return (cell + ((Permuted(other, side, key) + inside) / side)) / side;
    }

    /// <summary>A permutation of the whole numbers below a count: a bijection of the next power of two, walked on until it leads below the count.</summary>
    private static int Permuted(int number, int count, uint key)
    {
        int bits = BitOperations.Log2((uint)Math.Max(1, count - 1)) + 1;
        uint mask = (1u << bits) - 1, state = (uint)number;
        do
        {
            for (int round = 0; round < 4; round++)
            {
                uint random = (uint)(Mix(key + (uint)round) >> 32);
                state = ((state ^ random) * ((random >> 8) | 1)) & mask;
                state ^= state >> ((bits / 2) + 1);
            }
        }
        while (state >= count);
        return (int)state;
    }

    /// <summary>Position of a sample of the regular pattern along one axis, (0, 1).</summary>
    public static double Regular(RenderOptions options, int sample, int axis)
    {
        int side = Side(options);
        return ((axis == 0 ? sample % side : sample / side) + 0.5) / side;
    }

    /// <summary>Position of a sample of Sobol's sequence along one axis, [0, 1); the number of samples does not matter.</summary>
    public static double Sobol(RenderOptions options, int pixelX, int pixelY, int sample, int axis) =>
        SobolSequence.At((uint)sample, axis, (uint)(Hash(options.Seed, pixelX, pixelY, axis - 2) >> 32));

    private static int Side(RenderOptions options) => (int)Math.Round(Math.Sqrt(options.Samples));

    /// <summary>64 random bits, a hash of the arguments (the finaliser of SplitMix64, Steele, Lea and Flood 2014).</summary>
    private static ulong Hash(int seed, int x, int y, int dimension)
    {
        ulong state = Mix(((ulong)(uint)seed << 32) | (uint)dimension);
        return Mix(state ^ (((ulong)(uint)x << 32) | (uint)y));
    }

    /// <summary>Mixes the bits of a number, one to one.</summary>
    public static ulong Mix(ulong z)
    {
        z += 0x9E3779B97F4A7C15;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return z ^ (z >> 31);
    }
}
