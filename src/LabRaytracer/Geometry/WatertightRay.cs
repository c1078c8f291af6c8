using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rays prepared for <see cref="WatertightTriangle"/>: what does not depend on the triangle.</summary>
/// <remarks>
/// Each lane's axes are turned cyclically (no mirroring), so that its direction's largest component lies along z; a shear then takes the direction to (0, 0, 1).
/// Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", Journal of Computer Graphics Techniques 2(1), 2013.
/// </remarks>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal readonly struct WatertightRay<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Origin, with turned axes.</summary>
    public readonly R OriginX, OriginY, OriginZ;

    /// <summary>Multiples of z that are added to x and y.</summary>
    public readonly R ShearX, ShearY;

    /// <summary>Ray parameter per unit of z.</summary>
    public readonly R ScaleZ;

    /// <summary>Masks: lanes whose direction is largest along object x, along object y.</summary>
    public readonly R AlongX, AlongY;

    /// <summary>The axis (0, 1, 2) that is the largest one in every active lane, or -1.</summary>
    public readonly int SharedAxis;

    /// <summary>Prepares rays.</summary>
    /// <param name="ray">The rays.</param>
    /// <param name="active">Mask of the lanes that count; nothing is promised for the others.</param>
    public WatertightRay(in RayLanes<R> ray, in R active)
    {
        R x = R.Abs(ray.DirectionX), y = R.Abs(ray.DirectionY), z = R.Abs(ray.DirectionZ);
        AlongX = IsAlong(0, x, y, z);
        AlongY = IsAlong(1, x, y, z);
        SharedAxis = FindSharedAxis(R.Bits(AlongX & active), R.Bits(AlongY & active), R.Bits(active));
        if (SharedAxis >= 0)
        {
            AlongX = SharedAxis == 0 ? R.True : R.Zero;
            AlongY = SharedAxis == 1 ? R.True : R.Zero;
        }

        (OriginX, OriginY, OriginZ) = Turn(ray.OriginX, ray.OriginY, ray.OriginZ);
        (R directionX, R directionY, R directionZ) = Turn(ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        ShearX = -directionX / directionZ;
        ShearY = -directionY / directionZ;
        ScaleZ = R.Of(1) / directionZ;
    }

    /// <summary>Prepares rays that are known to be largest along the same axis; nothing is promised for others.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public WatertightRay(in RayLanes<R> ray, int axis)
    {
        SharedAxis = axis;
        AlongX = axis == 0 ? R.True : R.Zero;
        AlongY = axis == 1 ? R.True : R.Zero;
        (OriginX, OriginY, OriginZ) = axis == 2 ? (ray.OriginX, ray.OriginY, ray.OriginZ)
            : axis == 1 ? (ray.OriginZ, ray.OriginX, ray.OriginY)
            : (ray.OriginY, ray.OriginZ, ray.OriginX);
        (R directionX, R directionY, R directionZ) = axis == 2 ? (ray.DirectionX, ray.DirectionY, ray.DirectionZ)
            : axis == 1 ? (ray.DirectionZ, ray.DirectionX, ray.DirectionY)
            : (ray.DirectionY, ray.DirectionZ, ray.DirectionX);
        ShearX = -directionX / directionZ;
        ShearY = -directionY / directionZ;
        ScaleZ = R.Of(1) / directionZ;
    }

    /// <summary>Prepares rays whose every lane counts.</summary>
    public WatertightRay(in RayLanes<R> ray)
        : this(ray, R.True)
    {
    }

    /// <summary>A vector with each lane's axes turned: (y, z, x), (z, x, y) or (x, y, z).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (R X, R Y, R Z) Turn(R x, R y, R z) => (
        R.Select(AlongX, y, R.Select(AlongY, z, x)),
        R.Select(AlongX, z, R.Select(AlongY, x, y)),
        R.Select(AlongX, x, R.Select(AlongY, y, z)));

    /// <summary>Mask: which directions are largest along an axis (0, 1, 2); of equal components, the one of the later axis.</summary>
    /// <param name="axis">The axis.</param>
    /// <param name="x">Magnitudes of the directions.</param>
    /// <param name="y">The same along y.</param>
    /// <param name="z">The same along z.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R IsAlong(int axis, R x, R y, R z)
    {
        R alongX = R.Less(y, x) & R.Less(z, x), alongY = R.Less(z, y) & ~alongX;
        return axis == 0 ? alongX : axis == 1 ? alongY : ~(alongX | alongY);
    }

    private static int FindSharedAxis(uint alongX, uint alongY, uint active) =>
        alongX == active ? 0
        : alongY == active ? 1
        : (alongX | alongY) == 0 ? 2
        : -1;
}
