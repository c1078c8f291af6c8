using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Where a computed pattern is asked for its value: points of its space, as many as a lane type is wide.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
internal readonly struct PatternPoint<R, F>
    where R : unmanaged, IReal<R>
    where F : unmanaged, IReal<F>
{
    /// <summary>Coordinates.</summary>
    public readonly R X, Y, Z;

    /// <summary>Width of the filter, in the space of the pattern; 0 for none.</summary>
    public readonly F Width;

    /// <summary>True if z is 0 everywhere.</summary>
    public readonly bool IsFlat;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public PatternPoint(R x, R y, R z, F width, bool isFlat) => (X, Y, Z, Width, IsFlat) = (x, y, z, width, isFlat);
}
