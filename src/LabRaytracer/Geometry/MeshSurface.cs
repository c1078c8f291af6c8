using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The geometry of a mesh at hits.</summary>
internal static unsafe class MeshSurface
{
    /// <summary>Surface points in object space.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="ray">The rays that hit, object space.</param>
    /// <param name="triangle">Triangle numbers.</param>
    /// <param name="a">Weights of vertex 1.</param>
    /// <param name="b">Weights of vertex 2.</param>
    /// <param name="s">The surface.</param>
    /// <remarks>The point is a mean of the vertices, never o + t d: its distance from the triangle does not grow with the ray's length.</remarks>
    public static void Compute<R, F, I>(MeshData mesh, in RayLanes<R> ray, in I triangle, in R a, in R b, out SurfaceLanes<R> s)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        s = default;
        I corner = triangle * I.Of(3);
        MeshCorners<I> at = new(mesh.Corners, corner, 3);
        mesh.Positions.Gather<R, F, I>(at.First, out R x0, out R y0, out R z0);
        Edge<R, F, I>(mesh.Positions, at.Second, x0, y0, z0, out R x1, out R y1, out R z1);
        Edge<R, F, I>(mesh.Positions, at.Third, x0, y0, z0, out R x2, out R y2, out R z2);
        s.PointX = s.LocalX = R.Fma(a, x1, R.Fma(b, x2, x0));
        s.PointY = s.LocalY = R.Fma(a, y1, R.Fma(b, y2, y0));
        s.PointZ = s.LocalZ = R.Fma(a, z1, R.Fma(b, z2, z0));
        s.Slack = Lane.Slack(Size(x0, x1, x2) + Size(y0, y1, y2) + Size(z0, z1, z2));
        (R nx, R ny, R nz) = (Minor(y1, z2, z1, y2), Minor(z1, x2, x1, z2), Minor(x1, y2, y1, x2));
        Unit(ref nx, ref ny, ref nz, -ray.DirectionX, -ray.DirectionY, -ray.DirectionZ);
        (s.ShadingX, s.ShadingY, s.ShadingZ) = (nx, ny, nz);
        if (mesh.Normals.IsPresent)
        {
            ShadingNormal<R, F, I>(mesh, corner, a, b, ref s);
            R flip = R.Less(Lane.Dot(nx, ny, nz, s.ShadingX, s.ShadingY, s.ShadingZ), R.Zero);
            nx = R.Select(flip, -nx, nx);
            ny = R.Select(flip, -ny, ny);
            nz = R.Select(flip, -nz, nz);
        }

        (s.NormalX, s.NormalY, s.NormalZ) = (nx, ny, nz);
        (s.LocalNormalX, s.LocalNormalY, s.LocalNormalZ) = (nx, ny, nz);
        if (mesh.TextureCoordinates.IsPresent)
        {
            at = new MeshCorners<I>(mesh.TextureCorners, corner, 2);
            mesh.TextureCoordinates.Gather<R, F, I>(at.First, out R u0, out R v0, out R next);
            Edge<R, F, I>(mesh.TextureCoordinates, at.Second, u0, v0, next, out R u1, out R v1, out _);
            Edge<R, F, I>(mesh.TextureCoordinates, at.Third, u0, v0, next, out R u2, out R v2, out _);
            s.SurfaceU = R.Fma(a, u1, R.Fma(b, u2, u0));
            s.SurfaceV = R.Fma(a, v1, R.Fma(b, v2, v0));
        }
    }

    /// <summary>The interpolated normal, or the geometric one (which is in <paramref name="s"/>) where normals cancel.</summary>
    private static void ShadingNormal<R, F, I>(MeshData mesh, in I corner, in R a, in R b, ref SurfaceLanes<R> s)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        MeshCorners<I> at = new(mesh.NormalCorners, corner, 3);
        mesh.Normals.Gather<R, F, I>(at.First, out R x0, out R y0, out R z0);
        Edge<R, F, I>(mesh.Normals, at.Second, x0, y0, z0, out R x1, out R y1, out R z1);
        Edge<R, F, I>(mesh.Normals, at.Third, x0, y0, z0, out R x2, out R y2, out R z2);
        (R x, R y, R z) = (R.Fma(a, x1, R.Fma(b, x2, x0)), R.Fma(a, y1, R.Fma(b, y2, y0)), R.Fma(a, z1, R.Fma(b, z2, z0)));
        Unit(ref x, ref y, ref z, s.ShadingX, s.ShadingY, s.ShadingZ);
        (s.ShadingX, s.ShadingY, s.ShadingZ) = (x, y, z);
    }

    /// <summary>Changes of three numbers from vertex 0 to another one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Edge<R, F, I>(in MeshColumn column, in I element, in R x0, in R y0, in R z0, out R x, out R y, out R z)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        column.Gather<R, F, I>(element, out x, out y, out z);
        x -= x0;
        y -= y0;
        z -= z0;
    }

    /// <summary>a d - b c, within 1.5 ulp, so that slivers keep their normals.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Minor<R>(R a, R d, R b, R c)
        where R : unmanaged, IReal<R>
    {
        R product = b * c;
        return R.Fma(a, d, -product) + R.Fma(-b, c, product);
    }

    /// <summary>Sum of three magnitudes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Size<R>(R at0, R to1, R to2)
        where R : unmanaged, IReal<R> => R.Abs(at0) + R.Abs(to1) + R.Abs(to2);

    /// <summary>Mask of vectors that are 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R IsZero<R>(R x, R y, R z)
        where R : unmanaged, IReal<R> => R.Equal(x, R.Zero) & R.Equal(y, R.Zero) & R.Equal(z, R.Zero);

    /// <summary>A vector of length 1; the direction of a second one where the first is 0. Squares neither overflow nor vanish.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Unit<R>(ref R x, ref R y, ref R z, in R otherX, in R otherY, in R otherZ)
        where R : unmanaged, IReal<R>
    {
        R isZero = IsZero(x, y, z);
        x = R.Select(isZero, otherX, x);
        y = R.Select(isZero, otherY, y);
        z = R.Select(isZero, otherZ, z);
        R largest = R.Max(R.Max(R.Abs(x), R.Abs(y)), R.Abs(z));
        x /= largest;
        y /= largest;
        z /= largest;
        R length = R.Sqrt(Lane.Dot(x, y, z, x, y, z));
        x /= length;
        y /= length;
        z /= length;
    }
}
