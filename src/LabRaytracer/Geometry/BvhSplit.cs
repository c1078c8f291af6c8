using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A plane between bins that divides items in two.</summary>
internal unsafe struct BvhSplit
{
    // More bins than this find hardly better planes; few items need few.
    private const int Bins = 16, FewBins = 4, ItemsOfBin = 16;
    private BvhBins _bins;
    private int _lastLeftBin;

    /// <summary>Tells whether there is such a plane with items on both sides.</summary>
    public bool IsUseful { get; private set; }

    /// <summary>The axis across the plane.</summary>
    public int Axis { get; private set; }

    /// <summary>Half area times number of items, summed over both sides.</summary>
    public float Cost { get; private set; }

    /// <summary>The cheapest plane between the bins of any axis.</summary>
    [SkipLocalsInit]
    public static BvhSplit Find(BvhReference* references, in BvhRange range)
    {
        BvhSplit best = default;
        best.Cost = float.PositiveInfinity;
        int bins = Math.Min(Bins, FewBins + (range.Count / ItemsOfBin));
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
    public void Partition(BvhReference* references, in BvhRange range, out BvhRange left, out BvhRange right)
    {
        BvhRange low = BvhRange.Empty(range.First), high = BvhRange.Empty(0);
        BvhReference* first = references + range.First;
        BvhReference* last = first + range.Count - 1;
        int axis = Axis, lastLeft = _lastLeftBin;
        float start = _bins.Start(axis), scale = _bins.Scale(axis);
        while (true)
        {
            while (first <= last && BinOf(first, axis, start, scale) <= lastLeft)
            {
                low.Append(first++);
            }

            while (first <= last && BinOf(last, axis, start, scale) > lastLeft)
            {
                high.Append(last--);
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
            left.Append(references + range.First + i);
        }

        for (int i = half; i < range.Count; i++)
        {
            right.Append(references + range.First + i);
        }
    }

    /// <summary>The bin of an item along an axis: the same operations as when the bins were filled.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int BinOf(BvhReference* reference, int axis, float start, float scale) =>
        (int)(((&reference->MaxX)[axis] - (&reference->NegativeMinX)[axis] - start) * scale);

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
            side.Include(boxes[bin].Reach);
            count += counts[bin];
            rightCount[bin] = count;
            rightCost[bin] = count == 0 ? 0 : side.HalfArea * count;
        }

        side = BvhBox.Empty;
        count = 0;
        for (int bin = 0; bin < bins - 1; bin++)
        {
            side.Include(boxes[bin].Reach);
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
