namespace LabRaytracer;

/// <summary>The columns that a camera writes.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal unsafe struct RayColumns<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Origin, world space.</summary>
    public R* OriginX, OriginY, OriginZ;

    /// <summary>Direction, world space, length 1.</summary>
    public R* DirectionX, DirectionY, DirectionZ;
}
