using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Equal slices of the box of the items' centres, along each axis.</summary>
internal readonly unsafe struct BvhBins
{
    private readonly Float4 _start, _scale;
    private readonly int _count;

    /// <summary>Slices the centres of a range.</summary>
    public BvhBins(in BvhRange range, int count)
    {
        _start = range.Centers.Min;
        _count = count;

        // Just below the count, so that the largest centre falls into the last bin; a flat axis has all centres in bin 0.
        Float4 size = Float4.Max(range.Centers.Max - _start, Float4.Of(1e-30f));
        _scale = Float4.Of(0.9999f * count) / size;
    }

    /// <summary>The bin of an item along an axis.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int BinOf(BvhReference* reference, int axis) => Int4.Get(BinsOf(*(Float4*)&reference->MinX, *(Float4*)&reference->MaxX), axis);

    /// <summary>Boxes and counts of the bins: first those of x, then y, then z.</summary>
    public void Fill(BvhReference* references, in BvhRange range, BvhBox* boxes, int* counts)
    {
        for (int bin = 0; bin < 3 * _count; bin++)
        {
            boxes[bin] = BvhBox.Empty;
            counts[bin] = 0;
        }

        BvhReference* end = references + range.First + range.Count;
        for (BvhReference* reference = references + range.First; reference < end; reference++)
        {
            Float4 min = *(Float4*)&reference->MinX, max = *(Float4*)&reference->MaxX;
            Int4 bins = BinsOf(min, max);
            int x = Int4.Get(bins, 0), y = Int4.Get(bins, 1) + _count, z = Int4.Get(bins, 2) + (2 * _count);
            boxes[x].Include(min, max);
            boxes[y].Include(min, max);
            boxes[z].Include(min, max);
            counts[x]++;
            counts[y]++;
            counts[z]++;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private Int4 BinsOf(Float4 min, Float4 max) => Float4.ToInt32((min + max - _start) * _scale);
}
