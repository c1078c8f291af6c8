using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A plane between bins that divides items in two.</summary>
internal unsafe struct BvhSplit
{
    private const int Bins = 16;
    private BvhBins _bins;
    private int _lastLeftBin;

    /// <summary>Tells whether there is such a plane with items on both sides.</summary>
    public bool IsUseful { get; private set; }

    /// <summary>The axis across the plane.</summary>
    public int Axis { get; private set; }

    /// <summary>Half area times number of items, summed over both sides.</summary>
    public float Cost { get; private set; }

    /// <summary>Adds an item to a range.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Append(ref BvhRange range, BvhReference* reference)
    {
        Float4 min = *(Float4*)&reference->MinX, max = *(Float4*)&reference->MaxX;
        Float4 center = min + max;
        range.Box.Include(min, max);
        range.Centers.Include(center, center);
        range.Count++;
    }

    /// <summary>The cheapest plane between the bins of any axis.</summary>
    [SkipLocalsInit]
    public static BvhSplit Find(BvhReference* references, in BvhRange range)
    {
        BvhSplit best = default;
        best.Cost = float.PositiveInfinity;
        int bins = range.Count < 64 ? Bins / 2 : Bins;
        best._bins = new BvhBins(range, bins);
        BvhBox* boxes = stackalloc BvhBox[3 * Bins];
        int* counts = stackalloc int[3 * Bins];
        best._bins.Fill(references, range, boxes, counts);
        for (int axis = 0; axis < 3; axis++)
        {
            best.Sweep(axis, bins, boxes + (axis * bins), counts + (axis * bins));
        }

        return best;
    }

    /// <summary>Moves the items of the left side before those of the right side.</summary>
    public readonly void Partition(BvhReference* references, in BvhRange range, out BvhRange left, out BvhRange right)
    {
        BvhRange low = BvhRange.Empty(range.First), high = BvhRange.Empty(0);
        BvhReference* first = references + range.First;
        BvhReference* last = first + range.Count - 1;
        while (true)
        {
            while (first <= last && _bins.BinOf(first, Axis) <= _lastLeftBin)
            {
                Append(ref low, first++);
            }

            while (first <= last && _bins.BinOf(last, Axis) > _lastLeftBin)
            {
                Append(ref high, last--);
            }

            if (first >= last)
            {
                break;
            }

            (*first, *last) = (*last, *first);
        }

        high.First = low.First + low.Count;
        left = low;
        right = high;
    }

    /// <summary>Divides in two halves in the present order, for items that no plane can tell apart.</summary>
    public static void Halve(BvhReference* references, in BvhRange range, out BvhRange left, out BvhRange right)
    {
        int half = range.Count / 2;
        left = BvhRange.Empty(range.First);
        right = BvhRange.Empty(range.First + half);
        for (int i = 0; i < half; i++)
        {
            Append(ref left, references + range.First + i);
        }

        for (int i = half; i < range.Count; i++)
        {
            Append(ref right, references + range.First + i);
        }
    }

    /// <summary>Tries the planes of one axis, from both ends at once.</summary>
    [SkipLocalsInit]
    private void Sweep(int axis, int bins, BvhBox* boxes, int* counts)
    {
        float* rightCost = stackalloc float[Bins];
        int* rightCount = stackalloc int[Bins];
        BvhBox side = BvhBox.Empty;
        int count = 0;
        for (int bin = bins - 1; bin > 0; bin--)
        {
            side.Include(boxes[bin].Min, boxes[bin].Max);
            count += counts[bin];
            rightCount[bin] = count;
            rightCost[bin] = count == 0 ? 0 : side.HalfArea * count;
        }

        side = BvhBox.Empty;
        count = 0;
        for (int bin = 0; bin < bins - 1; bin++)
        {
            side.Include(boxes[bin].Min, boxes[bin].Max);
            count += counts[bin];
            if (count == 0 || rightCount[bin + 1] == 0)
            {
                continue;
            }

            float cost = (side.HalfArea * count) + rightCost[bin + 1];
            if (cost < Cost)
            {
                (Cost, Axis, _lastLeftBin, IsUseful) = (cost, axis, bin, true);
            }
        }
    }
}
