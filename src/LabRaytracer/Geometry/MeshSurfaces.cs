using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Surface points of hits on one mesh in world space, columns to columns: the bits of <see cref="MeshSurface"/>.</summary>
/// <remarks>Four hits at a time, which stay in registers; positions, normals and texture coordinates in loops of their own, which wait for memory on several hits at once.</remarks>
/// <typeparam name="Q">Four lanes of geometry's precision.</typeparam>
[SkipLocalsInit]
internal static unsafe class MeshSurfaces<Q>
    where Q : unmanaged, ILane<Q, Float4, Int4>, IQuad<Q>
{
    /// <summary>Surface points of hits.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="rays">The rays that hit.</param>
    /// <param name="hits">Their hits.</param>
    /// <param name="order">Numbers of the rays, padded to whole groups of lanes with valid numbers.</param>
    /// <param name="count">How many rays.</param>
    /// <param name="surfaces">Where the surface points go.</param>
    /// <param name="needs">Columns that somebody reads.</param>
    public static void Run<R, F, I>(MeshData mesh, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, SurfaceBatch<R, F, I> surfaces, SurfaceNeeds needs)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        MeshHitColumns<Q> from = new((Q*)hits.A, (Q*)hits.B, (int*)hits.Part, order, count, (count + R.Width - 1) / R.Width * (R.Width / Int4.Width));
        VectorColumns<Q> normals = new((Q*)surfaces.NormalX, (Q*)surfaces.NormalY, (Q*)surfaces.NormalZ);
        VectorColumns<Q> points = new((Q*)surfaces.PointX, (Q*)surfaces.PointY, (Q*)surfaces.PointZ);
        VectorColumns<Q> against = new((Q*)rays.DirectionX, (Q*)rays.DirectionY, (Q*)rays.DirectionZ);
        if (mesh.Positions.Singles != null)
        {
            Points(new MeshSinglePositions(mesh.Positions.Singles), mesh.Corners, from, against, points, normals, (Q*)surfaces.Slack);
        }
        else
        {
            Points(new MeshDoublePositions(mesh.Positions.Doubles), mesh.Corners, from, against, points, normals, (Q*)surfaces.Slack);
        }

        // Shared normals would say that there are no parts, which shadow rays that leave a triangle must know.
        surfaces.SharesNormals = false;
        VectorColumns<Q> shading = new((Q*)surfaces.ShadingX, (Q*)surfaces.ShadingY, (Q*)surfaces.ShadingZ);
        if (!mesh.Normals.IsPresent)
        {
            shading.CopyFrom(normals, from.Quads);
        }
        else if (mesh.Normals.Singles != null)
        {
            Normals(new MeshSinglePositions(mesh.Normals.Singles), mesh.NormalCorners, from, normals, shading);
        }
        else
        {
            Normals(new MeshDoublePositions(mesh.Normals.Doubles), mesh.NormalCorners, from, normals, shading);
        }

        if ((needs & SurfaceNeeds.SurfaceCoordinates) != 0)
        {
            Coordinates(mesh, from, (Q*)surfaces.Positions.SurfaceU, (Q*)surfaces.Positions.SurfaceV);
        }

        if ((needs & SurfaceNeeds.LocalPoint) != 0)
        {
            new VectorColumns<Q>((Q*)surfaces.Positions.X, (Q*)surfaces.Positions.Y, (Q*)surfaces.Positions.Z).CopyFrom(points, from.Quads);
        }

        if ((needs & SurfaceNeeds.LocalNormal) != 0)
        {
            new VectorColumns<Q>((Q*)surfaces.Positions.NormalX, (Q*)surfaces.Positions.NormalY, (Q*)surfaces.Positions.NormalZ).CopyFrom(normals, from.Quads);
        }
    }

    /// <summary>Points and geometric normals.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Points<P>(P rows, int* corners, in MeshHitColumns<Q> from, in VectorColumns<Q> rays, in VectorColumns<Q> points, in VectorColumns<Q> normals, Q* slack)
        where P : struct, IMeshPositions
    {
        for (int quad = 0; quad < from.Quads; quad++)
        {
            from.Edges(rows, corners, 3, quad, out Q x0, out Q y0, out Q z0, out Q x1, out Q y1, out Q z1, out Q x2, out Q y2, out Q z2);
            from.Weights(quad, out Q a, out Q b);
            points.Store(quad, Q.Fma(a, x1, Q.Fma(b, x2, x0)), Q.Fma(a, y1, Q.Fma(b, y2, y0)), Q.Fma(a, z1, Q.Fma(b, z2, z0)));
            slack[quad] = Lane.Slack(MeshSurface.Size(x0, x1, x2) + MeshSurface.Size(y0, y1, y2) + MeshSurface.Size(z0, z1, z2));
            Q x = MeshSurface.Minor(y1, z2, z1, y2), y = MeshSurface.Minor(z1, x2, x1, z2), z = MeshSurface.Minor(x1, y2, y1, x2);
            Q otherX = default, otherY = default, otherZ = default;
            if (Q.Any(MeshSurface.IsZero(x, y, z)))
            {
                LaneRun<Int4> run = from.Run(quad);
                (otherX, otherY, otherZ) = (-run.Collect<Q, Float4>(rays.X), -run.Collect<Q, Float4>(rays.Y), -run.Collect<Q, Float4>(rays.Z));
            }

            MeshSurface.Unit(ref x, ref y, ref z, otherX, otherY, otherZ);
            normals.Store(quad, x, y, z);
        }
    }

    /// <summary>Interpolated normals, which geometric ones follow.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Normals<P>(P rows, int* corners, in MeshHitColumns<Q> from, in VectorColumns<Q> normals, in VectorColumns<Q> shading)
        where P : struct, IMeshPositions
    {
        for (int quad = 0; quad < from.Quads; quad++)
        {
            from.Edges(rows, corners, 3, quad, out Q x0, out Q y0, out Q z0, out Q x1, out Q y1, out Q z1, out Q x2, out Q y2, out Q z2);
            from.Weights(quad, out Q a, out Q b);
            Q x = Q.Fma(a, x1, Q.Fma(b, x2, x0)), y = Q.Fma(a, y1, Q.Fma(b, y2, y0)), z = Q.Fma(a, z1, Q.Fma(b, z2, z0));
            Q nx = normals.X[quad], ny = normals.Y[quad], nz = normals.Z[quad];
            MeshSurface.Unit(ref x, ref y, ref z, nx, ny, nz);
            shading.Store(quad, x, y, z);
            Q flip = Q.Less(Lane.Dot(nx, ny, nz, x, y, z), Q.Zero);
            normals.Store(quad, Q.Select(flip, -nx, nx), Q.Select(flip, -ny, ny), Q.Select(flip, -nz, nz));
        }
    }

    private static void Coordinates(MeshData mesh, in MeshHitColumns<Q> from, Q* u, Q* v)
    {
        if (mesh.TextureCoordinates.Singles != null)
        {
            Coordinates(new MeshSinglePositions(mesh.TextureCoordinates.Singles), mesh.TextureCorners, from, u, v);
        }
        else if (mesh.TextureCoordinates.Doubles != null)
        {
            Coordinates(new MeshDoublePositions(mesh.TextureCoordinates.Doubles), mesh.TextureCorners, from, u, v);
        }
        else
        {
            new Span<Q>(u, from.Quads).Clear();
            new Span<Q>(v, from.Quads).Clear();
        }
    }

    /// <summary>Texture coordinates.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Coordinates<P>(P rows, int* corners, in MeshHitColumns<Q> from, Q* u, Q* v)
        where P : struct, IMeshPositions
    {
        for (int quad = 0; quad < from.Quads; quad++)
        {
            from.Edges(rows, corners, 2, quad, out Q u0, out Q v0, out _, out Q u1, out Q v1, out _, out Q u2, out Q v2, out _);
            from.Weights(quad, out Q a, out Q b);
            u[quad] = Q.Fma(a, u1, Q.Fma(b, u2, u0));
            v[quad] = Q.Fma(a, v1, Q.Fma(b, v2, v0));
        }
    }
}
