namespace LabRaytracer;

/// <summary>One object as the search sees it.</summary>
/// <param name="Number">Number in the scene.</param>
/// <param name="Group">The packed shapes of its class.</param>
/// <param name="Member">Its number there.</param>
/// <param name="Bounds">Box around it, world space.</param>
internal readonly record struct ObjectEntry<R, F, I>(int Number, ShapeGroup<R, F, I> Group, int Member, Bounds Bounds)
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>;
