namespace LabRaytracer;

/// <summary>A box with faces parallel to the axes (Polish: prostopadłościan); by default the cube [-1, 1]^3.</summary>
/// <remarks>
/// Immutable, thread safe. Hit from outside and from inside; the normal points outward. Use the transform of the scene object to turn it.
/// Local points are those of the cube [-1, 1]^3, on a face exactly.
/// </remarks>
public sealed class Box : Shape
{
    private static readonly BoxMapping s_mapping = new();

    /// <summary>Creates the cube [-1, 1]^3.</summary>
    public Box()
        : this(new Point3D(-1, -1, -1), new Point3D(1, 1, 1))
    {
    }

    /// <summary>Creates a box from two opposite corners, in any order.</summary>
    /// <param name="corner">A corner, object space; finite.</param>
    /// <param name="opposite">The opposite corner, object space; finite, different from the first in every coordinate.</param>
    /// <exception cref="ArgumentException">A corner is not finite, or the box is flat or too large for its size to be a number.</exception>
    public Box(Point3D corner, Point3D opposite)
    {
        Min = new Point3D(Math.Min(corner.X, opposite.X), Math.Min(corner.Y, opposite.Y), Math.Min(corner.Z, opposite.Z));
        Max = new Point3D(Math.Max(corner.X, opposite.X), Math.Max(corner.Y, opposite.Y), Math.Max(corner.Z, opposite.Z));
        Half = (Max - Min) * 0.5;
        Center = Min + Half;
        if (!Half.IsFinite || !(Half.X > 0 && Half.Y > 0 && Half.Z > 0))
        {
            throw new ArgumentException(
                $"A box needs two finite corners that differ in x, y and z; got {corner} and {opposite}. Use a Quad for a flat one.");
        }
    }

    /// <summary>Smallest coordinates, object space.</summary>
    public Point3D Min { get; }

    /// <summary>Largest coordinates, object space.</summary>
    public Point3D Max { get; }

    /// <inheritdoc/>
    public override Bounds Bounds => new Bounds(Min, Max).Grown(2);

    /// <inheritdoc/>
    /// <remarks><see cref="BoxMapping"/>.</remarks>
    public override IMapping DefaultMapping => s_mapping;

    /// <summary>Middle of the box, object space.</summary>
    internal Point3D Center { get; }

    /// <summary>Half the size along each axis, object units.</summary>
    internal Vector3D Half { get; }

    /// <inheritdoc/>
    public override bool Intersect(in Ray ray, double limit, out Hit hit) => ScalarKernel<BoxKernel>.Intersect(this, ray, limit, out hit);

    /// <inheritdoc/>
    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => ScalarKernel<BoxKernel>.SurfaceAt(this, ray, hit);

    internal override ShapeGroup<R, F, I> CreateGroup<R, F, I>(Transform transform) => KernelGroups.Create<BoxKernel, R, F, I>(transform);
}
