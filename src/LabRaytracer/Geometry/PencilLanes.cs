namespace LabRaytracer;

/// <summary>One group of lanes of a pencil of rays.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
internal struct PencilLanes<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>The rays, in the space of the mesh.</summary>
    public RayLanes<R> Ray;

    /// <summary>Largest ray parameters; not above 0 for lanes that are off.</summary>
    public R Limit;

    /// <summary>Slopes, exactly enough for <see cref="SlopeX"/> and <see cref="SlopeY"/>.</summary>
    public R FullX, FullY;

    /// <summary>Way along z a unit of ray parameter.</summary>
    public R Pace;

    /// <summary>Slopes: differences from the middle; 0 for lanes that are off.</summary>
    public F SlopeX, SlopeY;

    /// <summary>No hit with a larger w matters; below 0 for lanes that are off.</summary>
    public F Far;

    /// <summary>Shadow rays: every hit with a smaller w lies between lamp and surface. Other rays: every hit with a smaller w is nearer than what was found.</summary>
    public F Between;

    /// <summary>Shadow rays: the triangle that the ray leaves, or -1. Other rays: place of the triangle that is certainly hit, and nearer than anything else so far, or -1.</summary>
    public I Triangle;
}
