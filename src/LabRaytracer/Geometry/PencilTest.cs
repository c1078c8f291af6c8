using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The exact test of rays against a triangle each.</summary>
internal static unsafe class PencilTest
{
    /// <summary>Tests each ray against its triangle, with the bits of <see cref="MeshLeaf{R, F, I, P, TSink}"/>.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="triangles">Triangles in the order of the tree.</param>
    /// <param name="ray">The rays.</param>
    /// <param name="place">Places of the triangles.</param>
    /// <param name="hit">Mask of the rays that hit.</param>
    /// <param name="t">Ray parameters.</param>
    /// <param name="weight1">Weights of vertex 1.</param>
    /// <param name="weight2">Weights of vertex 2.</param>
    /// <param name="number">Numbers of the triangles in the mesh.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Run<R, F, I>(
        MeshData mesh, MeshTriangle* triangles, in RayLanes<R> ray, in I place, out R hit, out R t, out R weight1, out R weight2, out I number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        WatertightRay<R> watertight = new(ray);
        I fields = place * I.Of(sizeof(MeshTriangle) / sizeof(int));
        Vertex<R, F, I>(mesh, triangles, fields, out R x0, out R y0, out R z0);
        Vertex<R, F, I>(mesh, triangles, fields + I.Of(1), out R x1, out R y1, out R z1);
        Vertex<R, F, I>(mesh, triangles, fields + I.Of(2), out R x2, out R y2, out R z2);
        number = I.Gather((int*)triangles, fields + I.Of(3));
        hit = WatertightTriangle.Intersect(watertight, x0, y0, z0, x1, y1, z1, x2, y2, z2, out t, out weight1, out weight2);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Vertex<R, F, I>(MeshData mesh, MeshTriangle* triangles, I field, out R x, out R y, out R z)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I element = I.Gather((int*)triangles, field);
        mesh.Positions.Gather<R, F, I>(element, out x, out y, out z);
    }
}
