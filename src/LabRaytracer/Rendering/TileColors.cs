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

    /// <summary>Copies the sums (after <see cref="Average"/>: the means) of consecutive pixels.</summary>
    public void Copy(int first, Span<Intensity> pixels)
    {
        float* red = (float*)_sum.R + first, green = (float*)_sum.G + first, blue = (float*)_sum.B + first;
        int i = 0;
        for (; i <= pixels.Length - 4; i += 4)
        {
            LaneTriples.WriteFour(red + i, green + i, blue + i, ref Unsafe.As<Intensity, float>(ref pixels[i]));
        }

        for (; i < pixels.Length; i++)
        {
            pixels[i] = new Intensity(red[i], green[i], blue[i]);
        }
    }

    /// <summary>Starts a sample with the light of the camera rays.</summary>
    public void SetSample(in ColorColumns<F> radiance)
    {
        Copy(radiance.R, _sample.R);
        Copy(radiance.G, _sample.G);
        Copy(radiance.B, _sample.B);
    }

    /// <summary>Adds light to one pixel of the sample.</summary>
    public void AddToSample(int pixel, Intensity light) => _sample.Put(pixel, _sample.Take(pixel) + light);

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

    private void Copy(F* from, F* to) => new ReadOnlySpan<F>(from, _packets).CopyTo(new Span<F>(to, _packets));
}
