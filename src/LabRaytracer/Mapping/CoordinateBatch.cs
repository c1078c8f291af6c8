namespace LabRaytracer;

/// <summary>Columns of texture coordinates.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal unsafe struct CoordinateBatch<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Texture coordinates, v up.</summary>
    public R* U, V;
}
