namespace LabRaytracer;

/// <summary>Columns of <see cref="LightSample"/>: the light of one lamp that arrives at many points.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
internal unsafe struct LightColumns<R, F>
    where R : unmanaged, IReal<R>
    where F : unmanaged, IReal<F>
{
    /// <summary>Towards the lamp, world space, length 1.</summary>
    public R* DirectionX, DirectionY, DirectionZ;

    /// <summary>Distance of the lamp; infinite for directional light.</summary>
    public R* Distance;

    /// <summary>Light that arrives, linear; 0 where none does.</summary>
    public ColorColumns<F> Intensity;

    /// <summary>Cosine of the angle between lamp and normal for shading, not below 0; written where whoever makes the shadow rays says so.</summary>
    public F* Cosine;

    /// <summary>New columns.</summary>
    public LightColumns(LaneMemory memory, int capacity)
    {
        DirectionX = memory.Column<R>(capacity, R.Width);
        DirectionY = memory.Column<R>(capacity, R.Width);
        DirectionZ = memory.Column<R>(capacity, R.Width);
        Distance = memory.Column<R>(capacity, R.Width);
        Intensity = new ColorColumns<F>(memory, capacity);
        Cosine = memory.Column<F>(capacity, F.Width);
    }
}
