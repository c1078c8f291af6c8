using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Ray against triangle by the signs of edge functions: no gap along shared edges and vertices, and no epsilon.</summary>
/// <remarks>
/// <para>Each vertex is moved relative to the ray (<see cref="WatertightRay{R}"/>) by a formula that sees only this vertex, so neighbours agree about shared ones.
/// The sign of x1 y2 - y1 x2 is exact (Kahan's product difference by fma is within 1.5 ulp: Jeannerod, Louvet, Muller, "Further analysis of Kahan's algorithm",
/// Mathematics of Computation 82, 2013), hence neighbours also agree on which side of a shared edge the ray passes, in float lanes and in double lanes.
/// A ray exactly through an edge counts as inside for both. Exactness ends where products underflow: distances from the ray below 1e-145 (double), 1e-15 (float).</para>
/// <para>Source: Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", Journal of Computer Graphics Techniques 2(1), 2013.</para>
/// </remarks>
internal static class WatertightTriangle
{
    /// <summary>Intersects a triangle with vertices 0, 1, 2.</summary>
    /// <remarks>
    /// Vertices are in the ray's space. <paramref name="t"/> is the ray parameter, <paramref name="weight1"/> and <paramref name="weight2"/> are the weights of
    /// vertices 1 and 2 in [0, 1]; they mean nothing where the mask is false.
    /// </remarks>
    /// <returns>Mask of hits with 0 &lt; t &lt; infinity.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Intersect<R>(
        in WatertightRay<R> ray, R x0, R y0, R z0, R x1, R y1, R z1, R x2, R y2, R z2, out R t, out R weight1, out R weight2)
        where R : unmanaged, IReal<R>
    {
        (x0, y0, z0) = ray.Turn(x0, y0, z0);
        (x1, y1, z1) = ray.Turn(x1, y1, z1);
        (x2, y2, z2) = ray.Turn(x2, y2, z2);
        return IntersectTurned(ray, x0, y0, z0, x1, y1, z1, x2, y2, z2, out t, out weight1, out weight2);
    }

    /// <summary><see cref="Intersect"/> for vertices whose axes are turned already (<see cref="WatertightRay{R}.Turn"/>).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R IntersectTurned<R>(
        in WatertightRay<R> ray, R x0, R y0, R z0, R x1, R y1, R z1, R x2, R y2, R z2, out R t, out R weight1, out R weight2)
        where R : unmanaged, IReal<R>
    {
        (z0, z1, z2) = (z0 - ray.OriginZ, z1 - ray.OriginZ, z2 - ray.OriginZ);
        R inside = Edges(ray.OriginX, ray.OriginY, ray.ShearX, ray.ShearY, x0, y0, z0, x1, y1, z1, x2, y2, z2, out R edge0, out R edge1, out R edge2);
        if (!R.Any(inside))
        {
            t = weight1 = weight2 = R.Zero;
            return inside;
        }

        return inside & Distance(ray.ScaleZ, z0, z1, z2, edge0, edge1, edge2, out t, out weight1, out weight2);
    }

    /// <summary>
    /// The same without a branch, for rays whose numbers (<see cref="WatertightRay{R}"/>) are handed over one by one: where many pass a triangle's inside, nobody can tell which.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R IntersectTurned<R>(
        R originX, R originY, R originZ, R shearX, R shearY, R scaleZ, R x0, R y0, R z0, R x1, R y1, R z1, R x2, R y2, R z2, out R t, out R weight1, out R weight2)
        where R : unmanaged, IReal<R>
    {
        (z0, z1, z2) = (z0 - originZ, z1 - originZ, z2 - originZ);
        R inside = Edges(originX, originY, shearX, shearY, x0, y0, z0, x1, y1, z1, x2, y2, z2, out R edge0, out R edge1, out R edge2);
        return inside & Distance(scaleZ, z0, z1, z2, edge0, edge1, edge2, out t, out weight1, out weight2);
    }

    /// <summary>Edge functions of vertices whose z is relative to the ray's origin, and the mask of those that the line of the ray passes inside of.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Edges<R>(
        R originX, R originY, R shearX, R shearY, R x0, R y0, R z0, R x1, R y1, R z1, R x2, R y2, R z2, out R edge0, out R edge1, out R edge2)
        where R : unmanaged, IReal<R>
    {
        x0 = R.Fma(shearX, z0, x0 - originX);
        y0 = R.Fma(shearY, z0, y0 - originY);
        x1 = R.Fma(shearX, z1, x1 - originX);
        y1 = R.Fma(shearY, z1, y1 - originY);
        x2 = R.Fma(shearX, z2, x2 - originX);
        y2 = R.Fma(shearY, z2, y2 - originY);
        edge0 = Cross(x1, y1, x2, y2);
        edge1 = Cross(x2, y2, x0, y0);
        edge2 = Cross(x0, y0, x1, y1);
        return SameSign(edge0, edge1, edge2);
    }

    /// <summary>Ray parameters and weights; the mask is false where the parameter is not above 0 and finite.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Distance<R>(R scaleZ, R z0, R z1, R z2, R edge0, R edge1, R edge2, out R t, out R weight1, out R weight2)
        where R : unmanaged, IReal<R>
    {
        R toWeight = R.Of(1) / (edge0 + edge1 + edge2);
        t = Lane.Dot(edge0, edge1, edge2, z0, z1, z2) * toWeight * scaleZ;
        weight1 = edge1 * toWeight;
        weight2 = edge2 * toWeight;

        // A triangle seen edge-on has the sum 0: t is infinite or NaN then, which is no hit.
        return R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity));
    }

    /// <summary>x1 y2 - y1 x2 with the exact sign; it changes sign when the points are exchanged.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Cross<R>(R x1, R y1, R x2, R y2)
        where R : unmanaged, IReal<R>
    {
        R product = y1 * x2;
        R lost = R.Fma(-y1, x2, product);
        return R.Fma(x1, y2, -product) + lost;
    }

    /// <summary>Mask: all three are at least 0, or all are at most 0. NaN may pass; the distance is NaN then.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R SameSign<R>(R a, R b, R c)
        where R : unmanaged, IReal<R> =>
        R.LessOrEqual(R.Zero, R.Min(R.Min(a, b), c)) | R.LessOrEqual(R.Max(R.Max(a, b), c), R.Zero);
}
