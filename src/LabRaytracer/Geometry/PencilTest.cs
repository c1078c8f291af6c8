using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The exact test of rays against a triangle each.</summary>
internal static unsafe class PencilTest
{
    /// <summary>Tests each ray against its triangle, with the bits of <see cref="MeshSingleLeaf{P}"/>: four at a time, whose numbers stay in registers.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="triangles">Triangles in the order of the tree.</param>
    /// <param name="axis">Along which the rays that matter are largest.</param>
    /// <param name="ray">The rays, at least four, which stay where they are.</param>
    /// <param name="place">Places of the triangles.</param>
    /// <param name="hit">Mask of the rays that hit; nothing is promised for rays that do not matter.</param>
    /// <param name="t">Ray parameters.</param>
    /// <param name="weight1">Weights of vertex 1.</param>
    /// <param name="weight2">Weights of vertex 2.</param>
    /// <param name="number">Numbers of the triangles in the mesh.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    [SkipLocalsInit]
    public static void Run<R, F, I>(
        MeshData mesh, MeshTriangle* triangles, int axis, in RayLanes<R> ray, in I place, out R hit, out R t, out R weight1, out R weight2, out I number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        const int Rays = 4;
        Unsafe.SkipInit(out Hits<R> hits);
        RayLanes<R>* rays = (RayLanes<R>*)Unsafe.AsPointer(ref Unsafe.AsRef(in ray));
        I places = place;
        for (int first = 0; first < R.Width; first += Rays)
        {
            if (R.IsSingle)
            {
                Run(mesh, triangles, axis, (Float4*)rays, R.Width / Rays, first / Rays, (int*)&places + first, (Float4*)&hits);
            }
            else
            {
                Run(mesh, triangles, axis, (Double4*)rays, R.Width / Rays, first / Rays, (int*)&places + first, (Double4*)&hits);
            }
        }

        (hit, t, weight1, weight2) = (hits.Mask, hits.T, hits.Weight1, hits.Weight2);
        number = I.Gather((int*)triangles, (place * I.Of(sizeof(MeshTriangle) / sizeof(int))) + I.Of(3));
    }

    /// <summary>Four rays.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="triangles">Triangles in the order of the tree.</param>
    /// <param name="axis">The axis.</param>
    /// <param name="rays">Six columns of rays.</param>
    /// <param name="length">Vectors a column.</param>
    /// <param name="at">Which vector it is.</param>
    /// <param name="places">Places of its triangles.</param>
    /// <param name="hits">Receives four columns.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Run<Q>(MeshData mesh, MeshTriangle* triangles, int axis, Q* rays, int length, int at, int* places, Q* hits)
        where Q : unmanaged, IQuad<Q>
    {
        Q* own = rays + at;
        WatertightRay<Q> ray = new(new RayLanes<Q>(own[0], own[length], own[2 * length], own[3 * length], own[4 * length], own[5 * length]), axis);
        MeshTriangle* a = triangles + places[0], b = triangles + places[1], c = triangles + places[2], d = triangles + places[3];
        Turn(mesh.Positions, axis, a->Element0, b->Element0, c->Element0, d->Element0, out Q x0, out Q y0, out Q z0);
        Turn(mesh.Positions, axis, a->Element1, b->Element1, c->Element1, d->Element1, out Q x1, out Q y1, out Q z1);
        Turn(mesh.Positions, axis, a->Element2, b->Element2, c->Element2, d->Element2, out Q x2, out Q y2, out Q z2);
        hits[at] = WatertightTriangle.IntersectTurned(ray, x0, y0, z0, x1, y1, z1, x2, y2, z2, out hits[length + at], out hits[(2 * length) + at], out hits[(3 * length) + at]);
    }

    /// <summary>A vertex of each of four triangles, with turned axes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Turn<Q>(in MeshColumn positions, int axis, int a, int b, int c, int d, out Q x, out Q y, out Q z)
        where Q : unmanaged, IQuad<Q>
    {
        positions.Turn(a, b, c, d, out Q first, out Q second, out Q third);
        (x, y, z) = axis == 2 ? (first, second, third) : axis == 1 ? (third, first, second) : (second, third, first);
    }

    /// <summary>What is found.</summary>
    private struct Hits<R>
        where R : unmanaged
    {
        public R Mask, T, Weight1, Weight2;
    }
}
