using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The circle of radius 1.</summary>
internal readonly struct CircleOutline : IOutline
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Contains<R>(R x, R z)
        where R : unmanaged, IReal<R> => R.LessOrEqual(R.Fma(x, x, z * z), R.Of(1));
}
