namespace LabRaytracer;

/// <summary>Boxes of items in floats, rounded outward.</summary>
internal static unsafe class BvhReferences
{
    private const int Chunk = 16384;

    /// <summary>Writes one reference an item.</summary>
    public static void Fill<TItems>(TItems items, Point3D center, BvhReference* references, int threads)
        where TItems : struct, IBvhItems
    {
        int count = items.Count;
        int chunks = (count + Chunk - 1) / Chunk;
        if (threads == 1 || chunks == 1)
        {
            FillRange(items, center, references, 0, count);
            return;
        }

        ParallelOptions options = new() { MaxDegreeOfParallelism = threads };
        Parallel.For(0, chunks, options, chunk => FillRange(items, center, references, chunk * Chunk, Math.Min(count, (chunk + 1) * Chunk)));
    }

    private static void FillRange<TItems>(TItems items, Point3D center, BvhReference* references, int first, int end)
        where TItems : struct, IBvhItems
    {
        for (int item = first; item < end; item++)
        {
            Bounds bounds = items.BoundsOf(item);
            BvhReference* reference = references + item;
            reference->MinX = Below(bounds.Min.X, center.X);
            reference->MinY = Below(bounds.Min.Y, center.Y);
            reference->MinZ = Below(bounds.Min.Z, center.Z);
            reference->MaxX = -Below(-bounds.Max.X, -center.X);
            reference->MaxY = -Below(-bounds.Max.Y, -center.Y);
            reference->MaxZ = -Below(-bounds.Max.Z, -center.Z);
            reference->Number = item;
        }
    }

    /// <summary>A float not above value - center; a further step down covers the rounding of the subtraction.</summary>
    private static float Below(double value, double center)
    {
        double difference = value - center;
        float below = (float)difference;
        if (below > difference)
        {
            below = MathF.BitDecrement(below);
        }

        return center == 0 ? below : MathF.BitDecrement(below);
    }
}
