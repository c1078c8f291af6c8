namespace LabRaytracer;

/// <summary>Gradients of u and v with respect to the local point, as many as a lane type is wide.</summary>
/// <typeparam name="T">Lane type.</typeparam>
internal struct GradientLanes<T>
    where T : unmanaged, IReal<T>
{
    /// <summary>Gradient of u, object space.</summary>
    public T UX, UY, UZ;

    /// <summary>Gradient of v, object space.</summary>
    public T VX, VY, VZ;
}
