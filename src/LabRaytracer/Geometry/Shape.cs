namespace LabRaytracer;

/// <summary>A surface that rays can hit, in its own object space.</summary>
/// <remarks>
/// Derive from this class to add a shape of your own: <see cref="Intersect"/> and <see cref="SurfaceAt"/> for one ray in doubles are enough.
/// Built-in shapes add a path for many rays at a time with the same bits. Implementations must be immutable or at least not change while rendering:
/// the renderer calls them from several threads at once.
/// </remarks>
public abstract class Shape
{
    /// <summary>A box around the shape, object space; <see cref="Bounds.Everything"/> for unbounded shapes.</summary>
    public abstract Bounds Bounds { get; }

    /// <summary>The mapping used by textures that do not name one.</summary>
    public abstract IMapping DefaultMapping { get; }

    /// <summary>Finds the nearest hit with 0 &lt; t &lt; <paramref name="limit"/>.</summary>
    /// <param name="ray">Ray in object space; the direction need not have length 1.</param>
    /// <param name="limit">Largest ray parameter of interest, excluded; may be infinite.</param>
    /// <param name="hit">The hit; undefined when the ray misses.</param>
    /// <returns>False if the ray misses.</returns>
    public abstract bool Intersect(in Ray ray, double limit, out Hit hit);

    /// <summary>The geometry of the surface at a hit.</summary>
    /// <param name="ray">The ray that hit, object space.</param>
    /// <param name="hit">What <see cref="Intersect"/> returned for it.</param>
    public abstract SurfacePoint SurfaceAt(in Ray ray, in Hit hit);

    /// <summary>A new, empty group that holds shapes of this class for rendering.</summary>
    /// <param name="transform">Transform of the shape that asks; a group holds either untransformed or transformed shapes.</param>
    internal virtual ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => new CustomGroup<R, F, I>();
}
