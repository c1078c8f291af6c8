namespace LabRaytracer;

/// <summary>An axis-aligned box, both ends included; possibly empty or unbounded.</summary>
/// <param name="Min">Smallest coordinates, scene units.</param>
/// <param name="Max">Largest coordinates, scene units.</param>
/// <remarks>Immutable, thread safe. Empty when any <c>Min</c> coordinate exceeds its <c>Max</c>.</remarks>
public readonly record struct Bounds(Point3D Min, Point3D Max)
{
    /// <summary>The box that contains no point.</summary>
    public static Bounds Empty => new(
        new Point3D(double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity),
        new Point3D(double.NegativeInfinity, double.NegativeInfinity, double.NegativeInfinity));

    /// <summary>The box that contains every point.</summary>
    public static Bounds Everything => new(Empty.Max, Empty.Min);

    /// <summary>Tells whether the box contains no point.</summary>
    public bool IsEmpty => !(Min.X <= Max.X && Min.Y <= Max.Y && Min.Z <= Max.Z);

    /// <summary>Tells whether every coordinate is finite.</summary>
    public bool IsFinite => Min.IsFinite && Max.IsFinite;

    /// <summary>The smallest box that contains both boxes.</summary>
    public static Bounds Union(Bounds a, Bounds b) => new(
        new Point3D(Math.Min(a.Min.X, b.Min.X), Math.Min(a.Min.Y, b.Min.Y), Math.Min(a.Min.Z, b.Min.Z)),
        new Point3D(Math.Max(a.Max.X, b.Max.X), Math.Max(a.Max.Y, b.Max.Y), Math.Max(a.Max.Z, b.Max.Z)));

    /// <summary>The smallest box that contains this one and a point.</summary>
    public Bounds Including(Point3D point) => Union(this, new Bounds(point, point));

    /// <summary>The smallest box around this box after a transform; rounding errors are covered by an outward margin of 4 ulp a side.</summary>
    /// <param name="transform">Maps this box's space to the result's space.</param>
    public Bounds Transformed(Transform transform)
    {
        ArgumentNullException.ThrowIfNull(transform);
        if (IsEmpty || transform.IsIdentity)
        {
            return this;
        }

        if (!IsFinite)
        {
            return Everything;
        }

        Bounds result = Empty;
        for (int corner = 0; corner < 8; corner++)
        {
            Point3D point = new(
                (corner & 1) == 0 ? Min.X : Max.X,
                (corner & 2) == 0 ? Min.Y : Max.Y,
                (corner & 4) == 0 ? Min.Z : Max.Z);
            result = result.Including(transform.WorldFromObject(point));
        }

        return result.Grown(4);
    }

    /// <summary>The box with every face moved outward by a number of units in the last place of the largest coordinate.</summary>
    internal Bounds Grown(int ulps)
    {
        double largest = Math.Max(
            Math.Max(Math.Max(Math.Abs(Min.X), Math.Abs(Max.X)), Math.Max(Math.Abs(Min.Y), Math.Abs(Max.Y))),
            Math.Max(Math.Abs(Min.Z), Math.Abs(Max.Z)));
        double margin = ulps * (Math.BitIncrement(largest) - largest);
        Vector3D outward = new(margin, margin, margin);
        return new Bounds(Min - outward, Max + outward);
    }
}
