namespace LabRaytracer;

/// <summary>Differentials of camera rays.</summary>
internal static unsafe class CameraDifferentials
{
    /// <summary>Sets the differentials of the rays of a batch: steps from one sample to the next, a pixel divided by the root of the number of samples.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="rays">Its rays.</param>
    /// <param name="x">Horizontal positions on the picture, pixels.</param>
    /// <param name="y">Vertical positions on the picture, pixels.</param>
    /// <param name="options">Size of the picture.</param>
    /// <param name="samples">Samples of a pixel.</param>
    public static void Set<R, F, I>(Camera camera, RayBatch<R, F, I> rays, R* x, R* y, RenderOptions options, int samples)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        double spacing = 1 / Math.Sqrt(samples);
        rays.Pinhole = camera is PerspectiveCamera pinhole ? pinhole.Steps(options.Height, spacing) : null;
        if (rays.Pinhole is not null)
        {
            return;
        }

        if (camera is IWideCamera wide)
        {
            rays.Narrow();
            wide.Differentials(rays.SingleDirections, rays.Differentials, rays.Packets, options.Width, options.Height, spacing);
            return;
        }

        for (int i = 0; i < rays.Count; i++)
        {
            rays.Differentials.Put(i, camera.DifferentialAt(R.Take(x, i), R.Take(y, i), options.Width, options.Height), spacing);
        }
    }
}
