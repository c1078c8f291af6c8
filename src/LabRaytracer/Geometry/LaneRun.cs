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

    /// <param name="numbers">As many numbers as there are lanes, in any order.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public LaneRun(int* numbers)
    {
        Index = I.Load(numbers);
        First = numbers[0];
        IsConsecutive = I.AllEqual(Index - I.Iota(0), First);
    }

    /// <summary>The elements of a column of scalars.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public R Collect<R, F>(R* column)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I> => IsConsecutive
            ? Unsafe.ReadUnaligned<R>((byte*)column + ((long)First * (sizeof(R) / R.Width)))
            : R.Gather(column, Index);

    /// <summary>Rays and the elements of one more column.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RayLanes<R> Collect<R, F>(in RayColumns<R> rays, R* column, out R element)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
    {
        if (!IsConsecutive)
        {
            element = R.Gather(column, Index);
            return new RayLanes<R>(
                R.Gather(rays.OriginX, Index), R.Gather(rays.OriginY, Index), R.Gather(rays.OriginZ, Index),
                R.Gather(rays.DirectionX, Index), R.Gather(rays.DirectionY, Index), R.Gather(rays.DirectionZ, Index));
        }

        long at = (long)First * (sizeof(R) / R.Width);
        element = Read(column, at);
        return new RayLanes<R>(
            Read(rays.OriginX, at), Read(rays.OriginY, at), Read(rays.OriginZ, at), Read(rays.DirectionX, at), Read(rays.DirectionY, at), Read(rays.DirectionZ, at));
    }

    /// <summary>Vectors: three columns at once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Collect<R, F>(R* columnX, R* columnY, R* columnZ, out R x, out R y, out R z)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
    {
        if (!IsConsecutive)
        {
            (x, y, z) = (R.Gather(columnX, Index), R.Gather(columnY, Index), R.Gather(columnZ, Index));
            return;
        }

        long at = (long)First * (sizeof(R) / R.Width);
        (x, y, z) = (Read(columnX, at), Read(columnY, at), Read(columnZ, at));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Read<R>(R* column, long at)
        where R : unmanaged => Unsafe.ReadUnaligned<R>((byte*)column + at);

    /// <summary>The elements of a column of integers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public I Collect(I* column) => IsConsecutive ? I.Load((int*)column + First) : I.Gather((int*)column, Index);
}
