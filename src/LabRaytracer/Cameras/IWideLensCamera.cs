namespace LabRaytracer;

/// <summary>A wide camera with a lens.</summary>
internal interface IWideLensCamera : IWideCamera
{
    /// <summary>Moves rays from the middle of the lens to other points of it.</summary>
    /// <param name="s">Where on the lens, first coordinates of the unit square.</param>
    /// <param name="t">Where on the lens, second coordinates of the unit square.</param>
    /// <param name="rays">Rays from the middle; receives the others.</param>
    /// <param name="packets">Groups of lanes.</param>
    unsafe void Spread<R>(R* s, R* t, in RayColumns<R> rays, int packets)
        where R : unmanaged, IReal<R>;
}
