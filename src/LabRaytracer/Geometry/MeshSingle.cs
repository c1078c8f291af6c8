using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A single ray against a mesh, in its object space: against eight boxes and four triangles at a time.</summary>
internal static unsafe class MeshSingle
{
    /// <summary>Keeps the nearest hit with 0 &lt; t &lt;= limit.</summary>
    public static void Nearest(MeshData mesh, MeshTree tree, in RayLanes<Double1> ray, in BvhRay<Double1, Float1, Int1> boxRay, in MeshNearestSink<Double1, Float1, Int1> sink)
    {
        if (mesh.Positions.Singles != null)
        {
            Nearest(new MeshSinglePositions(mesh.Positions.Singles), tree, ray, boxRay, sink);
        }
        else
        {
            Nearest(new MeshDoublePositions(mesh.Positions.Doubles), tree, ray, boxRay, sink);
        }
    }

    [SkipLocalsInit]
    private static void Nearest<P>(P positions, MeshTree tree, in RayLanes<Double1> ray, in BvhRay<Double1, Float1, Int1> boxRay, in MeshNearestSink<Double1, Float1, Int1> sink)
        where P : struct, IMeshPositions
    {
        MeshSingleLeaf<P> leaf = new(tree.Triangles, positions, ray, boxRay, sink);
        BvhWideRay boxes = new(boxRay);
        BvhWideTraversal.Run(tree.Boxes, ref boxes, leaf.BoxLimit, ref leaf);
    }
}
