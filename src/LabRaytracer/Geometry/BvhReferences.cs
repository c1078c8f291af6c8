namespace LabRaytracer;

/// <summary>Writes the references of all items, several threads at a time.</summary>
internal static unsafe class BvhReferences
{
    private const int Chunk = 16384;

    /// <summary>Writes one reference an item; returns the range of them all.</summary>
    public static BvhRange Fill<TItems>(TItems items, Point3D center, BvhReference* references, int threads)
        where TItems : struct, IBvhItems
    {
        int count = items.Count;
        items.Prepare(center);
        BvhRange[] parts = new BvhRange[(count + Chunk - 1) / Chunk];
        if (threads == 1 || parts.Length == 1)
        {
            for (int part = 0; part < parts.Length; part++)
            {
                FillPart(items, center, references, part, out parts[part]);
            }
        }
        else
        {
            ParallelOptions options = new() { MaxDegreeOfParallelism = threads };
            Parallel.For(0, parts.Length, options, part => FillPart(items, center, references, part, out parts[part]));
        }

        items.Release();
        BvhRange all = BvhRange.Empty(0);
        for (int part = 0; part < parts.Length; part++)
        {
            all.Append(parts[part]);
        }

        return all;
    }

    private static void FillPart<TItems>(TItems items, Point3D center, BvhReference* references, int part, out BvhRange range)
        where TItems : struct, IBvhItems
    {
        int first = part * Chunk, end = Math.Min(items.Count, first + Chunk);
        items.Describe(center, references, first, end);
        range = BvhRange.Empty(first);
        for (int item = first; item < end; item++)
        {
            range.Append(references + item);
        }
    }
}
