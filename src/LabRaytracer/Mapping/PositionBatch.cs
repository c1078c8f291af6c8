namespace LabRaytracer;

/// <summary>Columns of surface positions: what a built-in mapping reads, many points at a time.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal unsafe struct PositionBatch<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Local point, object space.</summary>
    public R* X, Y, Z;

    /// <summary>Local unit normal, object space; only written when a mapping of the material asks for it.</summary>
    public R* NormalX, NormalY, NormalZ;

    /// <summary>The same point, world space; always written.</summary>
    public R* WorldX, WorldY, WorldZ;

    /// <summary>The geometric normal, world space; always written.</summary>
    public R* WorldNormalX, WorldNormalY, WorldNormalZ;

    /// <summary>The shape's own coordinates; only written by shapes that have them.</summary>
    public R* SurfaceU, SurfaceV;

    /// <summary>Gradient of the shape's own coordinates; only written by shapes that have them, for mappings' gradients.</summary>
    public GradientBatch<R> SurfaceGradient;
}
