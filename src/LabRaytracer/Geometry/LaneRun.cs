using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The numbers of the rays that one group of lanes stands for: any, or a run of consecutive ones, which is read at once instead of gathered.</summary>
/// <typeparam name="I">Integer lanes.</typeparam>
internal readonly unsafe struct LaneRun<I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>The numbers.</summary>
    public readonly I Index;

    /// <summary>The first one.</summary>
    public readonly int First;

    /// <summary>Tells whether they are consecutive.</summary>
    public readonly bool IsConsecutive;

    /// <param name="order">All numbers in increasing order, padded to whole groups of lanes.</param>
    /// <param name="first">Where in them this group of lanes starts.</param>
    /// <param name="count">How many numbers are not padding.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public LaneRun(int* order, int first, int count)
    {
        order += first;
        Index = I.Load(order);
        First = order[0];
        IsConsecutive = count - first >= I.Width && order[I.Width - 1] - First == I.Width - 1;
    }

    /// <summary>The elements of a column of scalars.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public R Collect<R, F>(R* column)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I> => IsConsecutive
            ? Unsafe.ReadUnaligned<R>((byte*)column + ((long)First * (sizeof(R) / R.Width)))
            : R.Gather(column, Index);

    /// <summary>The elements of a column of integers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public I Collect(I* column) => IsConsecutive ? I.Load((int*)column + First) : I.Gather((int*)column, Index);
}
