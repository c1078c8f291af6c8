namespace LabRaytracer;

/// <summary>Columns of surface points whose normals for shading are the geometric ones.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal unsafe struct SurfaceColumns<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Points and normals, local and world space.</summary>
    public PositionBatch<R> Positions;

    /// <summary>Bound of the error of each coordinate of the point, world space.</summary>
    public R* Slack;
}
