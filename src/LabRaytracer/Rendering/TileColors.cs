using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Colours of the pixels of a tile while its samples are summed up.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
/// <remarks>Samples are added in their order, light of one sample in the order in which it arose: the sums have the same bits for any size of batch.</remarks>
internal sealed unsafe class TileColors<F>
    where F : unmanaged, IReal<F>
{
    private ColorColumns<F> _sample;
    private ColorColumns<F> _sum;
    private readonly int _packets;

    public TileColors(LaneMemory memory, int pixels)
    {
        _sample = new ColorColumns<F>(memory, pixels);
        _sum = new ColorColumns<F>(memory, pixels);
        _packets = pixels / F.Width;
    }

    /// <summary>Tells whether every pixel is finite.</summary>
    public bool IsFinite
    {
        get
        {
            F zero = F.Zero;
            for (int packet = 0; packet < _packets; packet++)
            {
                // x - x is 0, and NaN for infinities and NaN.
                zero += (_sum.R[packet] - _sum.R[packet]) + (_sum.G[packet] - _sum.G[packet]) + (_sum.B[packet] - _sum.B[packet]);
            }

            return F.All(F.Equal(zero, F.Zero));
        }
    }

    /// <summary>Copies the sums (after <see cref="Average"/>: the means) of some consecutive pixels of a row.</summary>
    /// <param name="first">The first pixel.</param>
    /// <param name="to">Where they go.</param>
    /// <param name="count">How many, at most 4.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Copy(int first, Intensity* to, int count)
    {
        float* red = (float*)_sum.R + first, green = (float*)_sum.G + first, blue = (float*)_sum.B + first;
        if (count == 4)
        {
            LaneTriples.WriteFour(red, green, blue, (float*)to);
            return;
        }

        for (int i = 0; i < count; i++)
        {
            to[i] = new Intensity(red[i], green[i], blue[i]);
        }
    }

    /// <summary>Starts a sample with the light of the camera rays.</summary>
    /// <param name="radiance">The light; the columns are kept.</param>
    /// <returns>Other columns, for the next rays.</returns>
    public ColorColumns<F> SetSample(in ColorColumns<F> radiance)
    {
        ColorColumns<F> free = _sample;
        _sample = radiance;
        return free;
    }

    /// <summary>Adds light to one pixel of the sample.</summary>
    public void AddToSample(int pixel, Intensity light) => _sample.Put(pixel, _sample.Take(pixel) + light);

    /// <summary>Adds light to as many consecutive pixels of the sample as there are lanes.</summary>
    /// <param name="first">The first pixel.</param>
    /// <param name="red">The light.</param>
    /// <param name="green">The light.</param>
    /// <param name="blue">The light.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AddToSample(int first, F red, F green, F blue)
    {
        Add((float*)_sample.R + first, red);
        Add((float*)_sample.G + first, green);
        Add((float*)_sample.B + first, blue);
    }

    /// <summary>Light of one pixel of the sample.</summary>
    public Intensity TakeSample(int pixel) => _sample.Take(pixel);

    /// <summary>Sets the sum of one pixel.</summary>
    public void SetSum(int pixel, Intensity light) => _sum.Put(pixel, light);

    /// <summary>Starts the sums with the sample, which is given up.</summary>
    public void StartSum() => (_sum, _sample) = (_sample, _sum);

    /// <summary>Adds the sample to the sums.</summary>
    public void AddToSum()
    {
        for (int packet = 0; packet < _packets; packet++)
        {
            _sum.R[packet] += _sample.R[packet];
            _sum.G[packet] += _sample.G[packet];
            _sum.B[packet] += _sample.B[packet];
        }
    }

    /// <summary>Divides the sums by the number of samples.</summary>
    public void Average(int samples)
    {
        if (samples == 1)
        {
            return;
        }

        F share = F.Of(1f / samples);
        for (int packet = 0; packet < _packets; packet++)
        {
            _sum.R[packet] *= share;
            _sum.G[packet] *= share;
            _sum.B[packet] *= share;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Add(float* place, F light) => Unsafe.WriteUnaligned(place, Unsafe.ReadUnaligned<F>(place) + light);
}
