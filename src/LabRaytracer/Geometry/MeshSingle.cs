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
        if (R.IsSingle)
        {
            Run<R, F, I, Float4, Float1, MeshNearestSink<Float1, Float1, Int1>, Collector<R, F, I, Float1>>(mesh, tree, ray, boxRay, new(hits, packet, number));
        }
        else
        {
            Run<R, F, I, Double4, Double1, MeshNearestSink<Double1, Float1, Int1>, Collector<R, F, I, Double1>>(mesh, tree, ray, boxRay, new(hits, packet, number));
        }
    }

    /// <summary>Ends the rays of a group of lanes that are blocked: their limits become -1.</summary>
    public static void Block<R, F, I>(MeshData mesh, MeshTree tree, in RayLanes<R> ray, in BvhRay<R, F, I> boxRay, in I source, ref R limit)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R* limits = (R*)Unsafe.AsPointer(ref limit);
        if (R.IsSingle)
        {
            Run<R, F, I, Float4, Float1, MeshBlockSink<Float1, Float1, Int1>, Ender<R, F, I, Float1>>(mesh, tree, ray, boxRay, new(limits, source));
        }
        else
        {
            Run<R, F, I, Double4, Double1, MeshBlockSink<Double1, Float1, Int1>, Ender<R, F, I, Double1>>(mesh, tree, ray, boxRay, new(limits, source));
        }
    }

    /// <summary>Hands the hits of each active lane with 0 &lt; t &lt;= limit to a sink of its own, which lowers the limit.</summary>
    public static void Run<R, F, I, Q, R1, TSink, TSinks>(MeshData mesh, MeshTree tree, in RayLanes<R> ray, in BvhRay<R, F, I> boxRay, TSinks sinks)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where Q : unmanaged, IQuad<Q>
        where R1 : unmanaged, ILane<R1, Float1, Int1>
        where TSink : struct, IMeshSink<R1>
        where TSinks : struct, IMeshSinks<TSink>
    {
        if (mesh.Positions.Singles != null)
        {
            Run<R, F, I, Q, R1, MeshSinglePositions, TSink, TSinks>(new MeshSinglePositions(mesh.Positions.Singles), tree, ray, boxRay, sinks);
        }
        else
        {
            Run<R, F, I, Q, R1, MeshDoublePositions, TSink, TSinks>(new MeshDoublePositions(mesh.Positions.Doubles), tree, ray, boxRay, sinks);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    [SkipLocalsInit]
    private static void Run<R, F, I, Q, R1, P, TSink, TSinks>(P positions, MeshTree tree, in RayLanes<R> ray, in BvhRay<R, F, I> boxRay, TSinks sinks)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where Q : unmanaged, IQuad<Q>
        where R1 : unmanaged, ILane<R1, Float1, Int1>
        where P : struct, IMeshPositions
        where TSink : struct, IMeshSink<R1>
        where TSinks : struct, IMeshSinks<TSink>
    {
        MeshSingleLeaf<Q, R1, P, TSink> leaf = new(tree.Triangles, positions);
        Unsafe.SkipInit(out BvhWideRay boxes);
        for (uint active = boxRay.Active; active != 0; active &= active - 1)
        {
            int lane = BitOperations.TrailingZeroCount(active);
            leaf.Sink = sinks.Start(lane);
            float limit = leaf.Aim(ray, boxRay, lane);
            boxes.Aim(boxRay, lane);
            BvhWideTraversal.Run(tree.Boxes, ref boxes, limit, ref leaf);
            sinks.End(lane, leaf.Sink);
        }
    }

    /// <summary>Sinks that keep nearest hits in a batch.</summary>
    private readonly struct Collector<R, F, I, R1>(HitBatch<R, F, I> hits, int packet, int number) : IMeshSinks<MeshNearestSink<R1, Float1, Int1>>
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where R1 : unmanaged, ILane<R1, Float1, Int1>
    {
        public MeshNearestSink<R1, Float1, Int1> Start(int lane)
        {
            int element = (packet * R.Width) + lane;
            return new()
            {
                Object = number,
                T = (R1*)hits.T + element,
                A = (R1*)hits.A + element,
                B = (R1*)hits.B + element,
                Objects = (Int1*)hits.Object + element,
                Parts = (Int1*)hits.Part + element,
            };
        }

        public void End(int lane, in MeshNearestSink<R1, Float1, Int1> sink)
        {
        }
    }

    /// <summary>Sinks that end rays.</summary>
    private readonly struct Ender<R, F, I, R1>(R* limits, I source) : IMeshSinks<MeshBlockSink<R1, Float1, Int1>>
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where R1 : unmanaged, ILane<R1, Float1, Int1>
    {
        public MeshBlockSink<R1, Float1, Int1> Start(int lane) => new(Int1.Of(I.Get(source, lane)));

        public void End(int lane, in MeshBlockSink<R1, Float1, Int1> sink)
        {
            if (R1.Any(sink.Blocked))
            {
                R.Put(limits, lane, -1);
            }
        }
    }
}
