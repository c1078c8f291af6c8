namespace LabRaytracer;

/// <summary>Two steps in the tangent plane of each hit of a group, and what changes over them.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
internal sealed class SurfaceSteps<F>
    where F : unmanaged, IReal<F>
{
    public SurfaceSteps(LaneMemory memory, int capacity)
    {
        WorldDx = new VectorColumns<F>(memory, capacity);
        WorldDy = new VectorColumns<F>(memory, capacity);
        LocalDx = new VectorColumns<F>(memory, capacity);
        LocalDy = new VectorColumns<F>(memory, capacity);
        NormalDx = new VectorColumns<F>(memory, capacity);
        NormalDy = new VectorColumns<F>(memory, capacity);
        SurfaceGradient = new GradientBatch<F>(memory, capacity);
    }

    /// <summary>The steps, world space, in the tangent plane: what <see cref="ShapeGroup{R, F, I}.Differentiate"/> starts from.</summary>
    public VectorColumns<F> WorldDx { get; }

    /// <summary>The other step, world space.</summary>
    public VectorColumns<F> WorldDy { get; }

    /// <summary>The steps in the shape's unit form.</summary>
    public VectorColumns<F> LocalDx { get; }

    /// <summary>The other step in the shape's unit form.</summary>
    public VectorColumns<F> LocalDy { get; }

    /// <summary>Change of the shading normal over the first step, world space; perpendicular to it.</summary>
    public VectorColumns<F> NormalDx { get; }

    /// <summary>Change of the shading normal over the other step, world space.</summary>
    public VectorColumns<F> NormalDy { get; }

    /// <summary>Gradient of the shape's own coordinates with respect to the local point.</summary>
    public GradientBatch<F> SurfaceGradient { get; }
}
