using System.Numerics;

namespace LabRaytracer;

/// <summary>Random numbers of the pixels of a tile, for samples of lamps and lenses: from (seed, pixel, purpose) alone.</summary>
/// <remarks>
/// All samples of a pixel are one sequence that fills the square evenly; each pixel and each purpose scrambles it in its own way, so that neighbours' errors are independent.
/// </remarks>
internal sealed class PixelSampling(int seed, int pixels)
{
    private readonly ulong[] _states = new ulong[pixels];
    private readonly int[] _samples = new int[pixels];

    /// <summary>Number of the current sample of the pixels.</summary>
    public int Sample { get; private set; }

    /// <summary>Reflections and refractions so far.</summary>
    public int Depth { get; private set; }

    /// <summary>Starts a tile.</summary>
    /// <param name="x">Column of its top-left pixel in the whole picture.</param>
    /// <param name="y">Row of its top-left pixel.</param>
    /// <param name="place">Position of a pixel in the tile by its number.</param>
    public void StartTile(int x, int y, Func<int, (int X, int Y)> place)
    {
        for (int pixel = 0; pixel < pixels; pixel++)
        {
            (int px, int py) = place(pixel);
            Start(pixel, x + px, y + py, 0);
        }
    }

    /// <summary>Starts a sample of one pixel where a batch holds different samples of different pixels; <see cref="Sample"/> is then 0.</summary>
    /// <param name="slot">Number of the ray in the batch, which stands for the number of the pixel.</param>
    /// <param name="x">Column in the whole picture.</param>
    /// <param name="y">Row in the whole picture.</param>
    /// <param name="sample">Number of the sample.</param>
    public void Start(int slot, int x, int y, int sample)
    {
        _states[slot] = SampleOffsets.Mix(SampleOffsets.Mix((uint)seed) ^ (((ulong)(uint)x << 32) | (uint)y));
        _samples[slot] = sample;
    }

    /// <summary>Starts a sample of every pixel.</summary>
    public void StartSample(int sample) => Sample = sample;

    /// <summary>Starts the rays after a number of reflections and refractions.</summary>
    public void StartDepth(int depth) => Depth = depth;

    /// <summary>Two random 32-bit numbers that lead, by exclusive-or, from the first points of the sequence to those of the pixel's current sample.</summary>
    /// <param name="pixel">Number in the tile.</param>
    /// <param name="purpose">What for: different numbers for each.</param>
    /// <param name="points">Points of a sample.</param>
    /// <remarks>
    /// Samples take blocks of a power of two of points, in an order that is shuffled inside of ever larger blocks: all samples of a pixel fill the square evenly, and
    /// those of different purposes have nothing to do with each other. Bits of numbers that do not overlap add up by exclusive-or, which the sequence hands on to its
    /// points. Where points are no power of two, every sample is scrambled anew.
    /// </remarks>
    public (int First, int Second) Scramble(int pixel, int purpose, int points)
    {
        ulong random = SampleOffsets.Mix(_states[pixel] ^ (uint)purpose);
        uint sample = (uint)(_samples[pixel] + Sample);
        if (!BitOperations.IsPow2(points))
        {
            random = SampleOffsets.Mix(random ^ sample);
            return ((int)(random >> 32), (int)random);
        }

        uint start = SobolSequence.Scramble(sample, (uint)SampleOffsets.Mix(random)) * (uint)points;
        return ((int)((uint)(random >> 32) ^ SquareSequence.First(start)), (int)((uint)random ^ SquareSequence.Second(start)));
    }
}
