namespace LabRaytracer;

/// <summary>The edge of a flat shape, in its local frame (x, z).</summary>
internal interface IOutline
{
    /// <summary>Mask of points inside the outline or on it.</summary>
    static abstract R Contains<R>(R x, R z)
        where R : unmanaged, IReal<R>;
}
