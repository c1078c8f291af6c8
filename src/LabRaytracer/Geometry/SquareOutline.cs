using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The square [-1, 1] x [-1, 1]: any parallelogram in its own frame.</summary>
internal readonly struct SquareOutline : IOutline
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Contains<R>(R x, R z)
        where R : unmanaged, IReal<R> => R.LessOrEqual(R.Abs(x), R.Of(1)) & R.LessOrEqual(R.Abs(z), R.Of(1));
}
