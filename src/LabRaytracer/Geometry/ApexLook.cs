namespace LabRaytracer;

/// <summary>A quick look in floats at a sphere by rays that all pass one point, camera or lamp: as <see cref="IShapeKernel.MayHit"/>, by one scalar product a ray.</summary>
/// <remarks>
/// <para>With D from the apex to the centre and d the direction away from the apex, length 1, the line passes the centre at a distance whose square is |D|^2 - (D . d)^2: it meets
/// the sphere only if D . d is at least sqrt(|D|^2 - r^2), the length of the tangents. Spheres around the apex are always looked at.</para>
/// <para>With u = 2^-24 and S the sum of the largest coordinates of apex, origins and centre, in magnitude: rays pass the apex within 48u S at most, in float lanes, and the kernel in floats
/// sees spheres grown by 16u S at most (<see cref="SphereKernel.MayHit"/>). D and d are rounded to float and their product is, and d has length 1 but for a few u: together at most 16u |D|.
/// The sphere is grown by 128u S, and the tangents are shortened by 32u |D|.</para>
/// </remarks>
internal readonly unsafe struct ApexLook
{
    private const double Unit = 1.0 / (1 << 24);

    private readonly Vector3D _toCenter;
    private readonly double _tangent;

    /// <param name="bounds">Bounds of rays that have an apex.</param>
    /// <param name="center">Centre of the sphere.</param>
    /// <param name="radius">Its radius, which may be infinite.</param>
    public ApexLook(in RayBounds bounds, Point3D center, double radius)
    {
        Vector3D away = center - bounds.Apex;
        double size = bounds.Size + RayBounds.Sum(center);
        double grown = radius + (128 * Unit * size), square = away.LengthSquared - (grown * grown);
        _toCenter = away * bounds.Sense;
        _tangent = square > 0 ? Math.Sqrt(square) - (32 * Unit * away.Length) : double.NegativeInfinity;
    }

    /// <summary>Lists the groups of lanes that may hit.</summary>
    /// <param name="directions">Directions of the rays, rounded to float.</param>
    /// <param name="first">First group of lanes.</param>
    /// <param name="end">Group of lanes after the last one.</param>
    /// <param name="seen">Receives their numbers.</param>
    /// <returns>How many.</returns>
    public int Run<F>(VectorColumns<F> directions, int first, int end, int* seen)
        where F : unmanaged, IReal<F>
    {
        F x = F.Of(_toCenter.X), y = F.Of(_toCenter.Y), z = F.Of(_toCenter.Z), tangent = F.Of(_tangent);
        int count = 0;
        for (int packet = first; packet < end; packet++)
        {
            seen[count] = packet;
            count += F.Any(F.LessOrEqual(tangent, Lane.Dot(directions.X[packet], directions.Y[packet], directions.Z[packet], x, y, z))) ? 1 : 0;
        }

        return count;
    }
}
