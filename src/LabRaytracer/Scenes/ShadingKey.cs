namespace LabRaytracer;

/// <summary>What all hits of one group have in common: the class of the shape and the material.</summary>
internal sealed record ShadingKey<R, F, I>(ShapeGroup<R, F, I> Group, CompiledMaterial Material)
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>;
