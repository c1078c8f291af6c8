using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Equal slices of the box of the items' centres, along each axis.</summary>
internal unsafe struct BvhBins
{
    private readonly int _count;
    private Float4 _start, _scale;

    /// <summary>Slices the centres of a range.</summary>
    public BvhBins(in BvhRange range, int count)
    {
        _start = range.MinCenter;
        _count = count;

        // Just below the count, so that the largest centre falls into the last bin; a flat axis has all centres in bin 0.
        Float4 size = Float4.Max(range.MaxCenter - _start, Float4.Of(1e-30f));
        _scale = Float4.Of(0.9999f * count) / size;
    }

    /// <summary>Where the slices of an axis start, in twice the items' coordinates.</summary>
    public float Start(int axis) => Unsafe.Add(ref Unsafe.As<Float4, float>(ref _start), axis);

    /// <summary>Slices in a unit of length, of twice the items' coordinates.</summary>
    public float Scale(int axis) => Unsafe.Add(ref Unsafe.As<Float4, float>(ref _scale), axis);

    /// <summary>Boxes and counts of the bins: first those of x, then y, then z.</summary>
    public readonly void Fill(BvhReference* references, in BvhRange range, BvhBox* boxes, int* counts)
    {
        Float4 start = _start, scale = _scale;
        int bins = _count;
        for (int bin = 0; bin < 3 * bins; bin++)
        {
            boxes[bin] = BvhBox.Empty;
            counts[bin] = 0;
        }

        BvhReference* end = references + range.First + range.Count;
        for (BvhReference* reference = references + range.First; reference < end; reference++)
        {
            Float8 reach = BvhReference.ReachOf(reference);
            Int4 number = Float4.ToInt32((BvhRange.CenterOf(reach) - start) * scale);
            int x = Int4.Get(number, 0), y = Int4.Get(number, 1) + bins, z = Int4.Get(number, 2) + (2 * bins);
            boxes[x].Include(reach);
            boxes[y].Include(reach);
            boxes[z].Include(reach);
            counts[x]++;
            counts[y]++;
            counts[z]++;
        }
    }
}
