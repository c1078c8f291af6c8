namespace LabRaytracer;

/// <summary>A camera that makes many rays at a time, with the same bits as one at a time.</summary>
internal interface IWideCamera
{
    /// <summary>Rays of the positions (x, y), pixels from the top-left corner, of a picture of the given size.</summary>
    /// <param name="x">Columns of horizontal positions.</param>
    /// <param name="y">Columns of vertical positions.</param>
    /// <param name="rays">Where origins and directions go: six columns (origin x, y, z, direction x, y, z). Of cameras with <see cref="HasOneOrigin"/>, the first three may be null.</param>
    /// <param name="packets">Groups of lanes.</param>
    /// <param name="width">Width of the whole picture, pixels.</param>
    /// <param name="height">Height of the whole picture, pixels.</param>
    unsafe void Rays<R>(R* x, R* y, in RayColumns<R> rays, int packets, int width, int height)
        where R : unmanaged, IReal<R>;

    /// <summary>Tells whether all rays of all pictures start at the same point. Default: no.</summary>
    bool HasOneOrigin => false;

    /// <summary>Bounds of all rays through a rectangle of the picture, if they are known without looking at each. Default: they are not.</summary>
    /// <param name="left">Least x, pixels from the left.</param>
    /// <param name="right">Largest x.</param>
    /// <param name="top">Least y, pixels from the top.</param>
    /// <param name="bottom">Largest y.</param>
    /// <param name="width">Width of the whole picture, pixels.</param>
    /// <param name="height">Height of the whole picture, pixels.</param>
    RayBounds? Bounds(double left, double right, double top, double bottom, int width, int height) => null;

    /// <summary>Differentials of the rays with given directions; origins do not matter to them.</summary>
    /// <param name="directions">Unit directions of the camera's rays.</param>
    /// <param name="differentials">Where the differentials go, for steps of <paramref name="spacing"/>.</param>
    /// <param name="packets">Groups of lanes.</param>
    /// <param name="width">Width of the whole picture, pixels.</param>
    /// <param name="height">Height of the whole picture, pixels.</param>
    /// <param name="spacing">Distance of samples, pixels.</param>
    void Differentials<T>(in VectorColumns<T> directions, in DifferentialColumns<T> differentials, int packets, int width, int height, double spacing)
        where T : unmanaged, IReal<T>;
}
