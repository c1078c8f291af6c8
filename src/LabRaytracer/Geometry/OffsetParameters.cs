using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The parameters behind the first few of others.</summary>
internal readonly struct OffsetParameters<R, P>(P inner, int offset) : IParameters<R>
    where R : unmanaged, IReal<R>
    where P : struct, IParameters<R>
{
    public R this[int k]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => inner[k + offset];
    }
}
