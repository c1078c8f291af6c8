namespace LabRaytracer;

/// <summary>Bounds of rays that are known without looking at each. Directions count times a factor, another one for each ray, none below <paramref name="LeastFactor"/>.</summary>
/// <param name="LeastOrigin">No origin has a smaller coordinate.</param>
/// <param name="LargestOrigin">No origin has a larger coordinate.</param>
/// <param name="LeastDirection">No direction, times its ray's factor, has a smaller coordinate.</param>
/// <param name="LargestDirection">No direction, times its ray's factor, has a larger coordinate.</param>
/// <param name="LeastFactor">No factor is smaller; at least 0.</param>
/// <param name="Limit">No ray parameter over its ray's factor is of interest beyond.</param>
internal readonly record struct RayBounds(
    Point3D LeastOrigin, Point3D LargestOrigin, Vector3D LeastDirection, Vector3D LargestDirection, double LeastFactor, double Limit)
{
    /// <summary>The point through which all rays pass but for rounding, where they have one.</summary>
    public Point3D Apex { get; init; }

    /// <summary>1 where rays start at the <see cref="Apex"/>, -1 where they end there, 0 where there is none.</summary>
    public int Sense { get; init; }

    /// <summary>How far rays, and what float kernels see of shapes, may be off, as a part of all coordinates: twice what <see cref="RayBundle"/> reckons with.</summary>
    private const double Margin = 1.0 / (1 << 17);

    /// <summary>Tells whether any ray that ends at the apex may meet a sphere on its way; true for other rays.</summary>
    /// <param name="center">Centre of the sphere.</param>
    /// <param name="radius">Radius; may be infinite.</param>
    /// <remarks>All points of the ways are within half the diagonal of the origins' box of the line from its middle to the apex.</remarks>
    public bool MayMeetSphere(Point3D center, double radius)
    {
        if (Sense != -1)
        {
            return true;
        }

        Vector3D half = (LargestOrigin - LeastOrigin) / 2, way = Apex - (LeastOrigin + half), to = center - (LeastOrigin + half);
        double length = way.LengthSquared, along = length > 0 ? Math.Clamp(Vector3D.Dot(to, way) / length, 0, 1) : 0;
        double reach = radius + half.Length + (Margin * (Size + Sum(center)));
        return !((to - (way * along)).LengthSquared > reach * reach);
    }

    /// <summary>Tells whether any ray may meet a plane on its way.</summary>
    /// <param name="point">A point of the plane.</param>
    /// <param name="normal">Its normal, length 1.</param>
    public bool MayMeetPlane(Point3D point, Vector3D normal)
    {
        Vector3D half = (LargestOrigin - LeastOrigin) / 2;
        double height = Vector3D.Dot(normal, LeastOrigin + half - point), spread = Spread(normal, half), margin = Margin * (Size + Sum(point));
        if (!(Math.Abs(height) - spread > margin))
        {
            return true;
        }

        // All start on one side.
        Vector3D side = normal * Math.Sign(height), turn = (LargestDirection - LeastDirection) / 2;
        return Sense == -1
            ? !(Vector3D.Dot(side, Apex - point) > margin)
            : !(Vector3D.Dot(side, LeastDirection + turn) - Spread(side, turn) > Margin * (Largest(LeastDirection.X, LargestDirection.X)
                + Largest(LeastDirection.Y, LargestDirection.Y) + Largest(LeastDirection.Z, LargestDirection.Z)));
    }

    /// <summary>Sum of the largest coordinates of origins and apex, in magnitude.</summary>
    public double Size => Largest(LeastOrigin.X, LargestOrigin.X) + Largest(LeastOrigin.Y, LargestOrigin.Y) + Largest(LeastOrigin.Z, LargestOrigin.Z) + Sum(Apex);

    private static double Spread(Vector3D normal, Vector3D half) => (Math.Abs(normal.X) * half.X) + (Math.Abs(normal.Y) * half.Y) + (Math.Abs(normal.Z) * half.Z);

    private static double Largest(double least, double largest) => Math.Max(Math.Abs(least), Math.Abs(largest));

    /// <summary>Sum of a point's coordinates, in magnitude.</summary>
    public static double Sum(Point3D point) => Math.Abs(point.X) + Math.Abs(point.Y) + Math.Abs(point.Z);
}
