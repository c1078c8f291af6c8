using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Parameters of a different shape in each lane.</summary>
internal readonly unsafe struct GatheredParameters<R, F, I>(R* numbers, I first) : IParameters<R>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    public R this[int k]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => R.Gather(numbers, first + I.Of(k));
    }
}
