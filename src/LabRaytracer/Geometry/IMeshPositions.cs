using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A column of coordinates of a known precision.</summary>
internal interface IMeshPositions
{
    /// <summary>One coordinate in every lane.</summary>
    R At<R, F, I>(int element)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;

    /// <summary>Four consecutive numbers; the fourth belongs to the next vertex, or to nothing.</summary>
    Q Row<Q>(int element)
        where Q : unmanaged, IQuad<Q>;

    /// <summary>Says that a number will be read soon.</summary>
    void Prefetch(int element);
}

/// <summary>Coordinates in floats.</summary>
internal readonly unsafe struct MeshSinglePositions(float* numbers) : IMeshPositions
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public R At<R, F, I>(int element)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => R.IsSingle ? R.Broadcast((R*)numbers, element) : R.Of(numbers[element]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Q Row<Q>(int element)
        where Q : unmanaged, IQuad<Q> => Q.Load(numbers + element);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Prefetch(int element) => CacheLine.Prefetch(numbers + element);
}

/// <summary>Coordinates in doubles, read as float lanes see them.</summary>
internal readonly unsafe struct MeshRoundedPositions(double* numbers) : IMeshPositions
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public R At<R, F, I>(int element)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => R.Of((float)numbers[element]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Q Row<Q>(int element)
        where Q : unmanaged, IQuad<Q> => Q.LoadRounded(numbers + element);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Prefetch(int element) => CacheLine.Prefetch(numbers + element);
}

/// <summary>Coordinates in doubles.</summary>
internal readonly unsafe struct MeshDoublePositions(double* numbers) : IMeshPositions
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public R At<R, F, I>(int element)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => R.IsSingle ? R.Of(numbers[element]) : R.Broadcast((R*)numbers, element);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Q Row<Q>(int element)
        where Q : unmanaged, IQuad<Q> => Q.Load(numbers + element);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Prefetch(int element) => CacheLine.Prefetch(numbers + element);
}
