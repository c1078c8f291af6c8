using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Parameters of one shape, the same for every lane.</summary>
internal readonly unsafe struct SharedParameters<R, F, I>(R* numbers, int first) : IParameters<R>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    public R this[int k]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => R.Broadcast(numbers, first + k);
    }
}
