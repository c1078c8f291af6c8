namespace LabRaytracer;

/// <summary>The geometry of hits, as many as a lane type is wide: what a kernel computes of <see cref="SurfacePoint"/>.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal struct SurfaceLanes<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Hit point, in the space of the ray.</summary>
    public R PointX, PointY, PointZ;

    /// <summary>Outward geometric normal, length 1.</summary>
    public R NormalX, NormalY, NormalZ;

    /// <summary>Normal for shading, length 1.</summary>
    public R ShadingX, ShadingY, ShadingZ;

    /// <summary>The point in the shape's unit form.</summary>
    public R LocalX, LocalY, LocalZ;

    /// <summary>The outward normal in the shape's unit form, length 1.</summary>
    public R LocalNormalX, LocalNormalY, LocalNormalZ;

    /// <summary>The shape's own texture coordinates.</summary>
    public R SurfaceU, SurfaceV;

    /// <summary>Bound of the error of each coordinate of the point.</summary>
    public R Slack;
}
