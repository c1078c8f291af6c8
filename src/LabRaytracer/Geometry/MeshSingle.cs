using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A single ray against a mesh, in its object space: against eight boxes and four triangles at a time.</summary>
internal static unsafe class MeshSingle
{
    /// <summary>Hands the hits with 0 &lt; t &lt;= limit to a sink, which lowers the limit.</summary>
    public static void Run<TSink>(MeshData mesh, MeshTree tree, in RayLanes<Double1> ray, in BvhRay<Double1, Float1, Int1> boxRay, in TSink sink)
        where TSink : struct, IMeshSink<Double1>
    {
        if (mesh.Positions.Singles != null)
        {
            Run(new MeshSinglePositions(mesh.Positions.Singles), tree, ray, boxRay, sink);
        }
        else
        {
            Run(new MeshDoublePositions(mesh.Positions.Doubles), tree, ray, boxRay, sink);
        }
    }

    [SkipLocalsInit]
    private static void Run<P, TSink>(P positions, MeshTree tree, in RayLanes<Double1> ray, in BvhRay<Double1, Float1, Int1> boxRay, in TSink sink)
        where P : struct, IMeshPositions
        where TSink : struct, IMeshSink<Double1>
    {
        MeshSingleLeaf<Double4, Double1, P, TSink> leaf = new(tree.Triangles, positions) { Sink = sink };
        float limit = leaf.Aim(ray, boxRay, 0);
        Unsafe.SkipInit(out BvhWideRay boxes);
        boxes.Aim(boxRay, 0);
        BvhWideTraversal.Run(tree.Boxes, ref boxes, limit, ref leaf);
    }
}
