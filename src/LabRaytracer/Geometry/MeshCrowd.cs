using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Groups of lanes whose rays go their own ways, collected until there are enough to be searched for together.</summary>
/// <remarks>The same hits as <see cref="MeshSingle"/>, bit for bit: the same test of triangles, the same rules for what is kept.</remarks>
internal unsafe struct MeshCrowd
{
    /// <summary>Most rays.</summary>
    public const int Most = BvhCrowd.Most * BvhCrowdTraversal.Most;

    /// <summary>Bytes of the room for rays.</summary>
    public static readonly int Bytes = (BvhCrowdTraversal.Most * (sizeof(BvhCrowd) + sizeof(MeshCrowdRays))) + CacheLine.Bytes;

    private fixed int _packets[Most];
    private readonly BvhCrowd* _boxes;
    private readonly MeshCrowdRays* _rays;
    private int _count;

    /// <param name="room">Room for the rays.</param>
    public MeshCrowd(byte* room)
    {
        _boxes = (BvhCrowd*)CacheLine.Start(room);
        _rays = (MeshCrowdRays*)(_boxes + BvhCrowdTraversal.Most);
    }

    /// <summary>Adds a group of lanes, unless all its rays are off.</summary>
    /// <returns>Whether there is no room for another.</returns>
    public bool Add<R, F, I>(MeshTree tree, in RayLanes<R> ray, in R limit, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (!tree.Prepare(ray, limit, out BvhRay<R, F, I> boxRay))
        {
            return false;
        }

        int place = _count * R.Width, crowd = place / BvhCrowd.Most;
        place %= BvhCrowd.Most;
        if (place == 0)
        {
            _boxes[crowd].Clear();
        }

        _boxes[crowd].Add(boxRay, place);
        _rays[crowd].Add(ray, boxRay, place);
        _packets[_count++] = packet;
        return _count * R.Width == Most;
    }

    /// <summary>Keeps the nearest hits of all rays, which leave.</summary>
    public static void Nearest<R, F, I>(MeshCrowd* crowd, MeshData mesh, MeshTree tree, HitBatch<R, F, I> hits, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (R.IsSingle)
        {
            Run<Float4, Float1, Collector<R, F, I, Float1>>(crowd, mesh, tree, R.Width, new(crowd, hits, number));
        }
        else
        {
            Run<Double4, Double1, Collector<R, F, I, Double1>>(crowd, mesh, tree, R.Width, new(crowd, hits, number));
        }
    }

    /// <summary>Ends the rays that are blocked: their limits become -1. All rays leave.</summary>
    public static void Block<R, F, I>(MeshCrowd* crowd, MeshData mesh, MeshTree tree, RayBatch<R, F, I> rays, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (R.IsSingle)
        {
            Run<Float4, Float1, Ender<R, F, I, Float1>>(crowd, mesh, tree, R.Width, new(crowd, rays, number));
        }
        else
        {
            Run<Double4, Double1, Ender<R, F, I, Double1>>(crowd, mesh, tree, R.Width, new(crowd, rays, number));
        }
    }

    private static void Run<Q, R1, TSink>(MeshCrowd* crowd, MeshData mesh, MeshTree tree, int width, in TSink sink)
        where Q : unmanaged, IQuad<Q>
        where R1 : unmanaged, ILane<R1, Float1, Int1>
        where TSink : struct, IMeshCrowdSink<R1>
    {
        if (crowd->_count == 0)
        {
            return;
        }

        if (mesh.Positions.Singles != null)
        {
            Run<Q, R1, MeshSinglePositions, TSink>(crowd, new MeshSinglePositions(mesh.Positions.Singles), tree, width, sink);
        }
        else
        {
            Run<Q, R1, MeshDoublePositions, TSink>(crowd, new MeshDoublePositions(mesh.Positions.Doubles), tree, width, sink);
        }

        crowd->_count = 0;
    }

    [SkipLocalsInit]
    private static void Run<Q, R1, P, TSink>(MeshCrowd* crowd, P positions, MeshTree tree, int width, in TSink sink)
        where Q : unmanaged, IQuad<Q>
        where R1 : unmanaged, ILane<R1, Float1, Int1>
        where P : struct, IMeshPositions
        where TSink : struct, IMeshCrowdSink<R1>
    {
        byte* room = stackalloc byte[(MeshCrowdLeaf<Q, R1, P, TSink>.Numbers * sizeof(Q)) + CacheLine.Bytes];
        MeshCrowdLeaf<Q, R1, P, TSink> leaf = new(tree.Triangles, positions, crowd->_boxes, crowd->_rays, (Q*)CacheLine.Start(room), sink);
        int crowds = ((crowd->_count * width) + BvhCrowd.Most - 1) / BvhCrowd.Most;
        BvhCrowdTraversal.Run(tree.Boxes, crowd->_boxes, crowds, ref leaf);
    }

    /// <summary>Which group of lanes a ray belongs to, and which lane it is.</summary>
    private readonly int PacketOf(int ray, int width, out int lane)
    {
        lane = ray % width;
        return _packets[ray / width];
    }

    /// <summary>Keeps nearest hits in a batch.</summary>
    private readonly struct Collector<R, F, I, R1>(MeshCrowd* crowd, HitBatch<R, F, I> hits, int number) : IMeshCrowdSink<R1>
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where R1 : unmanaged, ILane<R1, Float1, Int1>
    {
        public bool Take(int ray, R1 t, R1 weight1, R1 weight2, int triangle, ref R1 limit)
        {
            int element = (crowd->PacketOf(ray, R.Width, out int lane) * R.Width) + lane;
            MeshNearestSink<R1, Float1, Int1> sink = new()
            {
                Object = number,
                T = (R1*)hits.T + element,
                A = (R1*)hits.A + element,
                B = (R1*)hits.B + element,
                Objects = (Int1*)hits.Object + element,
                Parts = (Int1*)hits.Part + element,
            };
            return sink.Take(R1.True, t, weight1, weight2, triangle, ref limit);
        }
    }

    /// <summary>Ends every ray that is hit before its limit, but not by the triangle that it leaves.</summary>
    private readonly struct Ender<R, F, I, R1>(MeshCrowd* crowd, RayBatch<R, F, I> rays, int number) : IMeshCrowdSink<R1>
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where R1 : unmanaged, ILane<R1, Float1, Int1>
    {
        public bool Take(int ray, R1 t, R1 weight1, R1 weight2, int triangle, ref R1 limit)
        {
            int packet = crowd->PacketOf(ray, R.Width, out int lane);
            if (!R1.Any(R1.Less(t, limit)) || I.Get(rays.SourceIn(packet, number), lane) == triangle)
            {
                return false;
            }

            limit = R1.Of(-1);
            R.Put(rays.Limit, (packet * R.Width) + lane, -1);
            return true;
        }
    }
}
