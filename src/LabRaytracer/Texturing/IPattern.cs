namespace LabRaytracer;

/// <summary>The formula of a computed texture: a number for every point of its space, written once for any width and precision.</summary>
internal interface IPattern
{
    /// <summary>The numbers at points. Implementations ask not to be inlined: they are the boundary of a kernel.</summary>
    /// <param name="point">Points and widths of the filter.</param>
    /// <param name="kept">What is left of the pattern where the filter is wide, [0, 1]: the rest is the mean colour of the ramp.</param>
    F At<R, F, I>(in PatternPoint<R, F> point, out F kept)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;
}
