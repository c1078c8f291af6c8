namespace LabRaytracer.Tests.Rendering;

/// <summary>Places of a sample in many pixels at once, against one at a time.</summary>
public unsafe class SampleFillTests
{
    [Theory]
    [InlineData(SamplePattern.Jittered, PixelFilter.Box)]
    [InlineData(SamplePattern.Jittered, PixelFilter.Mitchell)]
    [InlineData(SamplePattern.MultiJittered, PixelFilter.Tent)]
    [InlineData(SamplePattern.Sobol, PixelFilter.Box)]
    public void Fill_ManyPixels_SameBitsAsEach(SamplePattern pattern, PixelFilter filter)
    {
        const int Count = 256;
        SamplePlaces places = new(new RenderOptions { Samples = 9, Seed = -77, PixelFilter = filter }, pattern);
        ulong* pixels = stackalloc ulong[Count];
        double* filled = stackalloc double[Count];
        for (int i = 0; i < Count; i++)
        {
            pixels[i] = ((ulong)(uint)(i % 16) << 32) | (uint)(i / 16);
        }

        foreach ((int x, int y) in new[] { (0, 0), (1888, 1056), (int.MaxValue - 16, 3) })
        {
            for (int dimension = 0; dimension < 18; dimension++)
            {
                SampleAxis axis = places.Axis(dimension / 2, dimension % 2);
                places.Fill(axis, pixels, ((ulong)(uint)x << 32) | (uint)y, filled, Count);
                for (int i = 0; i < Count; i++)
                {
                    Assert.Equal(places.At(x + (i % 16), y + (i / 16), dimension / 2, dimension % 2), filled[i]);
                }
            }
        }
    }

    /// <summary>The published sequence of SplitMix64 from the state 1234567, whose upper 53 bits are the fractions.</summary>
    [Fact]
    public void Jitter_KnownSequence_IsThatOfSplitMix64()
    {
        ulong* numbers = stackalloc ulong[4];
        double* places = stackalloc double[4];
        for (int i = 0; i < 4; i++)
        {
            numbers[i] = (ulong)i * 0x9E3779B97F4A7C15;
        }

        LaneRandom.Jitter(numbers, 1234567, 0, cell: 2, side: 4, places, 4);
        ulong[] published = [6457827717110365317, 3203168211198807973, 9817491932198370423, 4593380528125082431];
        for (int i = 0; i < 4; i++)
        {
            Assert.Equal((2 + ((published[i] >> 11) / 9007199254740992.0)) / 4, places[i]);
        }
    }
}
