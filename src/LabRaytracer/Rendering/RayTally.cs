namespace LabRaytracer;

/// <summary>Number of rays that each pixel of a tile causes, as the statistics count them.</summary>
/// <param name="pixelOfRay">Number of the pixel of each ray of the batch that is traced; filled by the owner.</param>
/// <param name="pixels">Pixels of a tile.</param>
internal sealed unsafe class RayTally(int* pixelOfRay, int pixels)
{
    private readonly int[] _counts = new int[pixels];

    /// <summary>Starts a tile.</summary>
    public void Clear() => Array.Clear(_counts);

    /// <summary>Counts the rays of a batch that are on.</summary>
    public void Add<R, F, I>(RayBatch<R, F, I> rays)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        for (int ray = 0; ray < rays.Count; ray++)
        {
            Count(R.Take(rays.Limit, ray), ray);
        }
    }

    /// <summary>Counts the shadow rays of a group of hits that are on; before they are blocked.</summary>
    /// <param name="rays">A shadow ray for each hit.</param>
    /// <param name="order">Number of each hit's ray in its batch.</param>
    /// <param name="count">How many hits.</param>
    public void Add<R, F, I>(RayBatch<R, F, I> rays, int* order, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        for (int i = 0; i < count; i++)
        {
            Count(R.Take(rays.Limit, i), order[i]);
        }
    }

    /// <summary>The colour of a pixel's count.</summary>
    /// <param name="pixel">Number of the pixel in the tile.</param>
    /// <param name="samples">Samples a pixel.</param>
    public Intensity Color(int pixel, int samples) => SampleHeat.Color((double)_counts[pixel] / samples);

    private void Count(double limit, int ray)
    {
        if (!(limit < 0))
        {
            _counts[pixelOfRay[ray]]++;
        }
    }
}
