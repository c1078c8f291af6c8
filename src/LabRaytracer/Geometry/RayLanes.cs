using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>As many rays as a lane type is wide.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal readonly struct RayLanes<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Origin.</summary>
    public readonly R OriginX, OriginY, OriginZ;

    /// <summary>Direction; length 1 in world space, any length in object space.</summary>
    public readonly R DirectionX, DirectionY, DirectionZ;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RayLanes(R originX, R originY, R originZ, R directionX, R directionY, R directionZ)
    {
        OriginX = originX;
        OriginY = originY;
        OriginZ = originZ;
        DirectionX = directionX;
        DirectionY = directionY;
        DirectionZ = directionZ;
    }
}
