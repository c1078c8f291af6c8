namespace LabRaytracer;

/// <summary>The formula of a mapping that needs only the local point, written once for any width and precision.</summary>
internal interface IPointFormula
{
    /// <summary>Texture coordinates of local points.</summary>
    static abstract (T U, T V) Coordinates<T>(T x, T y, T z)
        where T : unmanaged, IReal<T>;

    /// <summary>Gradients of u and v with respect to the local points.</summary>
    static abstract void Gradient<T>(T x, T y, T z, out GradientLanes<T> gradient)
        where T : unmanaged, IReal<T>;
}
