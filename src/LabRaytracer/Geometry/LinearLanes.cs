using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Linear maps from one space to another, as many as a lane type is wide: three rows.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal struct LinearLanes<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>First row.</summary>
    public R XX, XY, XZ;

    /// <summary>Second row.</summary>
    public R YX, YY, YZ;

    /// <summary>Third row.</summary>
    public R ZX, ZY, ZZ;

    /// <summary>Vectors taken through the map.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly (R X, R Y, R Z) Apply(R x, R y, R z) =>
        (Lane.Dot(XX, XY, XZ, x, y, z), Lane.Dot(YX, YY, YZ, x, y, z), Lane.Dot(ZX, ZY, ZZ, x, y, z));

    /// <summary>Vectors taken back through the transposed map: what is perpendicular to a surface in the second space becomes so in the first.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly (R X, R Y, R Z) ApplyTransposed(R x, R y, R z) =>
        (Lane.Dot(XX, YX, ZX, x, y, z), Lane.Dot(XY, YY, ZY, x, y, z), Lane.Dot(XZ, YZ, ZZ, x, y, z));

    /// <summary>A map that scales along the axes.</summary>
    public static LinearLanes<R> Scaling(R x, R y, R z) => new() { XX = x, YY = y, ZZ = z };
}
