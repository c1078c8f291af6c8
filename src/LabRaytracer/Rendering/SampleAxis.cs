using System.Numerics;

namespace LabRaytracer;

/// <summary>Where one sample lies along one axis, in any pixel: from (seed, pixel, sample) alone, so that any pixel can be repeated by itself. What all pixels share is found once.</summary>
internal readonly struct SampleAxis
{
    private readonly SamplePattern _pattern;
    private readonly int _side, _cell, _other;
    private readonly uint _reversedPoint;
    private readonly ulong _inside, _key;

    /// <param name="options">Number of samples, seed.</param>
    /// <param name="pattern">The pattern.</param>
    /// <param name="sample">Number of the sample.</param>
    /// <param name="axis">0 for x, 1 for y.</param>
    public SampleAxis(RenderOptions options, SamplePattern pattern, int sample, int axis)
    {
        _pattern = pattern;
        if (pattern == SamplePattern.Sobol)
        {
            _reversedPoint = SobolSequence.Reversed(axis == 0 ? SquareSequence.First((uint)sample) : SquareSequence.Second((uint)sample));
            _key = Start(options.Seed, axis - 2);
            return;
        }

        _side = (int)Math.Round(Math.Sqrt(options.Samples));
        (int column, int row) = (sample % _side, sample / _side);
        (_cell, _other) = axis == 0 ? (column, row) : (row, column);
        _inside = Start(options.Seed, (2 * sample) + axis);
        _key = Start(options.Seed, -3 - (2 * _cell) - axis);
    }

    /// <summary>The place in a pixel, [0, 1).</summary>
    /// <param name="pixelX">Column in the whole picture.</param>
    /// <param name="pixelY">Row in the whole picture.</param>
    public double At(int pixelX, int pixelY)
    {
        ulong pixel = ((ulong)(uint)pixelX << 32) | (uint)pixelY;
        switch (_pattern)
        {
            case SamplePattern.Regular:
                return (_cell + 0.5) / _side;
            case SamplePattern.Jittered:
                return (_cell + Fraction(pixel)) / _side;
            case SamplePattern.MultiJittered:
                // Cells in one column take different parts of it: which one is a permutation of their rows, another one in each column; likewise the other way around.
                return (_cell + ((Permuted(_other, _side, Key(pixel)) + Fraction(pixel)) / _side)) / _side;
            default:
                return SobolSequence.Unit * SobolSequence.ScrambleReversed(_reversedPoint, Key(pixel));
        }
    }

    /// <summary>The places in many pixels, as by <see cref="At"/>.</summary>
    /// <param name="pixels">Pixels relative to the first one: column in the upper half, row in the lower one.</param>
    /// <param name="first">The first pixel, likewise.</param>
    /// <param name="places">Receives the places.</param>
    /// <param name="count">How many; a multiple of 4.</param>
    public unsafe void Fill(ulong* pixels, ulong first, double* places, int count)
    {
        if (_pattern == SamplePattern.Jittered)
        {
            LaneRandom.Jitter(pixels, first, _inside, _cell, _side, places, count);
            return;
        }

        if (_pattern == SamplePattern.Sobol)
        {
            LaneRandom.Scramble(pixels, first, _key, _reversedPoint, places, count);
            return;
        }

        for (int i = 0; i < count; i++)
        {
            ulong pixel = pixels[i] + first;
            places[i] = At((int)(pixel >> 32), (int)(uint)pixel);
        }
    }

    /// <summary>Evenly distributed, [0, 1).</summary>
    private double Fraction(ulong pixel) => (SampleOffsets.Mix(_inside ^ pixel) >> 11) * (1.0 / (1UL << 53));

    private uint Key(ulong pixel) => (uint)(SampleOffsets.Mix(_key ^ pixel) >> 32);

    private static ulong Start(int seed, int dimension) => SampleOffsets.Mix(((ulong)(uint)seed << 32) | (uint)dimension);

    /// <summary>A permutation of the whole numbers below a count: a bijection of the next power of two, walked on until it leads below the count.</summary>
    private static int Permuted(int number, int count, uint key)
    {
        int bits = BitOperations.Log2((uint)Math.Max(1, count - 1)) + 1;
        uint mask = (1u << bits) - 1, state = (uint)number;
        do
        {
            for (int round = 0; round < 4; round++)
            {
                uint random = (uint)(SampleOffsets.Mix(key + (uint)round) >> 32);
                state = ((state ^ random) * ((random >> 8) | 1)) & mask;
                state ^= state >> ((bits / 2) + 1);
            }
        }
        while (state >= count);
        return (int)state;
    }
}
