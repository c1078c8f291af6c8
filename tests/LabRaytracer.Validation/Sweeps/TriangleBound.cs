namespace LabRaytracer.Validation;

/// <summary>How wrong the watertight test may be on one triangle: the running error bound of its formulas.</summary>
/// <remarks>
/// With u half a unit in the last place of 1, axes turned as <see cref="WatertightRay{R}"/> turns them, and vertices p relative to the origin of the ray: the sheared
/// x of a vertex is wrong by at most 3u X with X = |p.x| + |shear p.z|, y likewise; so an edge function x1 y2 - y1 x2, itself within 3u, by at most
/// E = 3u (X1 |y2| + |x1| Y2 + Y1 |x2| + |y1| X2 + |edge|). With S the sum of the three edge functions, a weight w = edge / S is wrong by at most
/// ((1 - w) E + w (the other two E)) / |S| + 4u w, and t, the weighted mean of the z times a scale, by at most scale (sum of E |z - mean| / |S| + 8u sum of w |z|).
/// |S| is taken less by what it may be wrong; where nothing is left, the bounds are infinite.
/// </remarks>
internal readonly struct TriangleBound
{
    /// <summary>Bounds of the edge functions opposite to vertices 0, 1, 2.</summary>
    public readonly double[] Edges = new double[3];

    /// <summary>Bounds of the weights of vertices 0, 1, 2.</summary>
    public readonly double[] Weights = new double[3];

    /// <summary>Bound of t.</summary>
    public readonly double T;

    /// <param name="exact">The exact answer, whose weights enter.</param>
    /// <param name="ray">The ray.</param>
    /// <param name="vertices">The triangle.</param>
    /// <param name="isSingle">True for float lanes.</param>
    public TriangleBound(in ExactTriangle exact, in Ray ray, Point3D[] vertices, bool isSingle)
    {
        double unit = isSingle ? 1.0 / (1 << 24) : 1.0 / (1L << 53);
        double[] d = [ray.Direction.X, ray.Direction.Y, ray.Direction.Z];
        int axis = exact.Axis, right = (axis + 1) % 3, up = (axis + 2) % 3;
        double shearX = d[right] / d[axis], shearY = d[up] / d[axis], sum = Math.Abs(exact.Sum);
        double[] wideX = new double[3], wideY = new double[3], x = new double[3], y = new double[3], z = new double[3];
        for (int k = 0; k < 3; k++)
        {
            Vector3D p = vertices[k] - ray.Origin;
            double[] at = [p.X, p.Y, p.Z];
            z[k] = at[axis];
            (x[k], y[k]) = (Math.Abs(exact.ShearedX[k]), Math.Abs(exact.ShearedY[k]));
            wideX[k] = Math.Abs(at[right]) + Math.Abs(shearX * z[k]);
            wideY[k] = Math.Abs(at[up]) + Math.Abs(shearY * z[k]);
        }

        for (int k = 0; k < 3; k++)
        {
            (int i, int j) = ((k + 1) % 3, (k + 2) % 3);
            Edges[k] = 3 * unit * ((wideX[i] * y[j]) + (x[i] * wideY[j]) + (wideY[i] * x[j]) + (y[i] * wideX[j]) + Math.Abs(exact.Edges[k]));
        }

        double all = Edges[0] + Edges[1] + Edges[2], least = Math.Max(0, sum - all), mean = 0, size = 0, lever = 0;
        for (int k = 0; k < 3; k++)
        {
            double w = exact.Weights[k].ToDouble();
            Weights[k] = (((1 - w) * Edges[k]) + (w * (all - Edges[k]))) / least + (4 * unit * w);
            mean += w * z[k];
            size += w * Math.Abs(z[k]);
        }

        for (int k = 0; k < 3; k++)
        {
            lever += Edges[k] * Math.Abs(z[k] - mean);
        }

        T = ((lever / least) + (8 * unit * size)) / Math.Abs(d[axis]);
    }
}
