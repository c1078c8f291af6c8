using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rays against a mesh one after the other, each against eight boxes and four triangles at a time: for rays that go their own ways.</summary>
/// <remarks>The same hits as <see cref="MeshSearch"/>, bit for bit: the same test of triangles, the same sinks.</remarks>
internal static unsafe class MeshSingle
{
    /// <summary>Keeps the nearest hits of a group of lanes.</summary>
    public static void Nearest<R, F, I>(
        MeshData mesh, MeshTree tree, in RayLanes<R> ray, in BvhRay<R, F, I> boxRay, HitBatch<R, F, I> hits, int packet, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        for (uint active = boxRay.Active; active != 0; active &= active - 1)
        {
            int lane = BitOperations.TrailingZeroCount(active), element = (packet * R.Width) + lane;
            if (R.IsSingle)
            {
                MeshNearestSink<Float1, Float1, Int1> sink = SinkOf<R, F, I, Float1>(hits, element, number);
                Run<R, F, I, Float4, Float1, MeshNearestSink<Float1, Float1, Int1>>(mesh, tree, ray, boxRay, lane, ref sink);
            }
            else
            {
                MeshNearestSink<Double1, Float1, Int1> sink = SinkOf<R, F, I, Double1>(hits, element, number);
                Run<R, F, I, Double4, Double1, MeshNearestSink<Double1, Float1, Int1>>(mesh, tree, ray, boxRay, lane, ref sink);
            }
        }
    }

    /// <summary>Ends the rays of a group of lanes that are blocked: their limits become -1.</summary>
    public static void Block<R, F, I>(MeshData mesh, MeshTree tree, in RayLanes<R> ray, in BvhRay<R, F, I> boxRay, ref R limit)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        for (uint active = boxRay.Active; active != 0; active &= active - 1)
        {
            int lane = BitOperations.TrailingZeroCount(active);
            bool isBlocked;
            if (R.IsSingle)
            {
                MeshBlockSink<Float1> sink = default;
                Run<R, F, I, Float4, Float1, MeshBlockSink<Float1>>(mesh, tree, ray, boxRay, lane, ref sink);
                isBlocked = Float1.Any(sink.Blocked);
            }
            else
            {
                MeshBlockSink<Double1> sink = default;
                Run<R, F, I, Double4, Double1, MeshBlockSink<Double1>>(mesh, tree, ray, boxRay, lane, ref sink);
                isBlocked = Double1.Any(sink.Blocked);
            }

            if (isBlocked)
            {
                R.Put((R*)Unsafe.AsPointer(ref limit), lane, -1);
            }
        }
    }

    private static MeshNearestSink<R1, Float1, Int1> SinkOf<R, F, I, R1>(HitBatch<R, F, I> hits, int element, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where R1 : unmanaged, ILane<R1, Float1, Int1> => new()
        {
            Object = number,
            T = (R1*)hits.T + element,
            A = (R1*)hits.A + element,
            B = (R1*)hits.B + element,
            Objects = (Int1*)hits.Object + element,
            Parts = (Int1*)hits.Part + element,
        };

    /// <summary>Hands the hits of one lane with 0 &lt; t &lt;= limit to a sink, which lowers the limit.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Run<R, F, I, Q, R1, TSink>(
        MeshData mesh, MeshTree tree, in RayLanes<R> ray, in BvhRay<R, F, I> boxRay, int lane, ref TSink sink)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where Q : unmanaged, IQuad<Q>
        where R1 : unmanaged, ILane<R1, Float1, Int1>
        where TSink : struct, IMeshSink<R1>
    {
        RayLanes<Q> own = new(
            Q.Of(Get(ray.OriginX, lane)), Q.Of(Get(ray.OriginY, lane)), Q.Of(Get(ray.OriginZ, lane)),
            Q.Of(Get(ray.DirectionX, lane)), Q.Of(Get(ray.DirectionY, lane)), Q.Of(Get(ray.DirectionZ, lane)));
        R1 limit = R1.Of(Get(boxRay.Limit, lane)), toFloat = R1.Of(Get(boxRay.ToFloat, lane));
        float boxLimit = (float)Float1.Get(BvhRay<R1, Float1, Int1>.LimitOf(limit, toFloat), 0);
        BvhWideRay wideRay = BvhWideRay.Of(boxRay, lane);
        if (mesh.Positions.Singles != null)
        {
            MeshSingleLeaf<Q, R1, MeshSinglePositions, TSink> leaf = new(tree.Triangles, new MeshSinglePositions(mesh.Positions.Singles), own, limit, toFloat, sink);
            BvhWideTraversal.Run(tree.Boxes, wideRay, boxLimit, ref leaf);
            sink = leaf.Sink;
        }
        else
        {
            MeshSingleLeaf<Q, R1, MeshDoublePositions, TSink> leaf = new(tree.Triangles, new MeshDoublePositions(mesh.Positions.Doubles), own, limit, toFloat, sink);
            BvhWideTraversal.Run(tree.Boxes, wideRay, boxLimit, ref leaf);
            sink = leaf.Sink;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Get<R>(in R lanes, int lane)
        where R : unmanaged, IReal<R> => Lane.Take((R*)Unsafe.AsPointer(ref Unsafe.AsRef(in lanes)), lane);
}
