namespace LabRaytracer;

/// <summary>How far the exact test of triangles (<see cref="WatertightTriangle"/>) may be from what is exactly true of the lines of a pencil.</summary>
/// <remarks>
/// <para>Float lanes, u = 2^-24. The test moves a vertex p relative to a ray with origin o and slope s (at most 1) to x = (px - ox) - s (pz - oz), with relative errors of at
/// most u in both differences, in s and in the sum: it is wrong by at most u (3 |pz - oz| + 2 |x|), and y likewise. The pencil's line through the apex differs from the ray's by
/// how far the ray passes the apex, and by z times the error of its slopes, 2 u and, sheared by k, (3 + |k|) u, where z is the vertex's distance along z from the apex.
/// So the test sees a triangle moved as a whole, by at most c = beside + (3 + |k|) u z, and every vertex moved on its own, by at most
/// a = u (3 |pz - oz| + 2 |x| + (3 + |k|) d) with d the triangle's depth along z, along x and along y each.</para>
/// <para>An edge function, x1 y2 - y1 x2, whose sign the test finds exactly, is then off by at most c L + a (l1 + l2) + 2 a^2, where L is how long edges look at most and
/// l how far moved vertices are beside the line, both sums of |x| and |y|. If the line is inside the triangle, l is at most L + 2 c; if the test sees it inside, L + 6 a. So
/// the bound (c + 2 a) L + a (14 a + 4 c) holds wherever it decides: if all three edge functions are above it, the test hits; if the test hits, none is below its negative.
/// For such hits, |pz - oz| is at most d, or the way from origins to the triangle.</para>
/// <para>Its distance t is a mean of the vertices' z, with the edge functions as weights, and 16 roundings: between the least and the largest z, but for 16 u times the
/// largest. The volume, which is that mean times the sum of the edge functions, is off by the largest z times the sum of their errors.</para>
/// <para>Vertices of prepared triangles (<see cref="PencilTriangles"/>) are rounded to float once they are sheared so that the pencil's middle is z: seen by a ray whose slopes are at
/// most sx and sy, by at most u (|x| + sx |z|) along x and u (|y| + sy |z|) along y, which is added to a, sheared back.</para>
/// <para>Double lanes: without those roundings, a and c but for the apex are at most 2^-46 of the pencil's size, far below <see cref="Floor"/>, which is always part of a.</para>
/// </remarks>
internal static class PencilErrors
{
    /// <summary>Directions with a smaller largest component are no pencil, nor those with a larger one than the inverse: distances might not be normal floats.</summary>
    public const double LeastPace = 1e-10;

    /// <summary>2^-24, and a little more for what is of second order.</summary>
    public const double Unit = 6e-8;

    /// <summary>Part of a pencil's size below which no error bound is, so that bounds are normal numbers.</summary>
    public const double Floor = 1.0 / (1L << 34);

    /// <summary>Sets size and errors of a pencil.</summary>
    /// <param name="pencil">Receives them.</param>
    /// <param name="apex">The apex.</param>
    /// <param name="mesh">Where the mesh is.</param>
    /// <param name="deviation">Largest distance of a ray's end from the apex, as the sum of three coordinates, as lanes found it; 0 for rays that start in the apex.</param>
    /// <param name="way">Largest way of a ray along the pencil's axis; 0 for rays that start in the apex.</param>
    /// <returns>Whether the errors are small, and all numbers normal in floats, as products of three and in error bounds.</returns>
    public static bool SetSize<R>(ref RayPencil pencil, Point3D apex, in BvhFrame mesh, double deviation, double way)
        where R : unmanaged, IReal<R>
    {
        // An origin is at most sqrt(3) times its way along the largest axis from the apex; its coordinates add up to three times that.
        double toApex = Math.Abs(apex.X) + Math.Abs(apex.Y) + Math.Abs(apex.Z), size = mesh.Size + toApex + (3 * way);
        pencil.Size = size;
        pencil.Way = way * (1 + (4 * Unit));
        if (R.IsSingle)
        {
            // The apex is exact, the points at the limits are rounded once.
            pencil.Beside = way == 0 ? 0 : (deviation * 1.0001) + (Unit * toApex);
            pencil.TestError = (size / (1 << 19)) + pencil.Beside;
            pencil.LimitError = (size / (1 << 20)) + pencil.Beside;
            pencil.Nearest = (size / (1 << 18)) + (2 * pencil.Beside);
            return size is > 1.0 / (1 << 10) and < 1 << 20 && deviation <= size * 1e-5;
        }

        pencil.Beside = way == 0 ? 0 : deviation + (size * 1.7763568394002505e-15);
        pencil.TestError = (size / (1L << 47)) + pencil.Beside;
        pencil.LimitError = size * 1e-9;
        pencil.Nearest = size / (1 << 20);
        return size is > 1.0 / (1 << 20) and < 1 << 30 && deviation <= size * 1e-12;
    }
}
