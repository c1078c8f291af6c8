using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Meshes of a scene, each with its own tree of boxes.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
/// <param name="isTransformed">Whether rays must be taken to object space.</param>
internal sealed unsafe class MeshGroup<R, F, I>(bool isTransformed) : ShapeGroup<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly List<(TriangleMesh Mesh, Transform Transform, int Number)> _members = [];
    private MeshTree[] _trees = [];
    private R* _transforms;

    public override int Add(Shape shape, Transform transform, int number)
    {
        _members.Add(((TriangleMesh)shape, transform, number));
        return _members.Count - 1;
    }

    public override void Freeze(LaneMemory memory, int threads)
    {
        _trees = [.. _members.Select(member => member.Mesh.Tree(threads))];
        if (!isTransformed)
        {
            return;
        }

        _transforms = memory.Column<R>(_members.Count * WorldSpace.ParameterCount, R.Width);
        Span<double> numbers = stackalloc double[WorldSpace.ParameterCount];
        for (int member = 0; member < _members.Count; member++)
        {
            WorldSpace.Describe(_members[member].Transform, numbers);
            for (int k = 0; k < numbers.Length; k++)
            {
                R.Put(_transforms, (member * WorldSpace.ParameterCount) + k, numbers[k]);
            }
        }
    }

    [SkipLocalsInit]
    public override void Nearest(int member, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int first, int end)
    {
        (TriangleMesh mesh, _, int number) = _members[member];
        const int Most = MeshPencil.MostPackets;
        byte* room = stackalloc byte[(Most * sizeof(PencilLanes<R, F, I>)) + CacheLine.Bytes];
        PencilLanes<R, F, I>* lanes = (PencilLanes<R, F, I>*)CacheLine.Start(room);
        byte* crowdRoom = stackalloc byte[MeshCrowd.Bytes];
        MeshCrowd crowd = new(crowdRoom);
        for (int packet = first; packet < end; packet += Most)
        {
            int count = Math.Min(Most, end - packet);
            if (Load(member, rays, hits.T, packet, count, lanes))
            {
                MeshHalves.Nearest(mesh.Data, _trees[member], lanes, count, &crowd, hits, packet, number);
            }
        }

        MeshCrowd.Nearest(&crowd, mesh.Data, _trees[member], hits, number);
    }

    [SkipLocalsInit]
    public override void Block(int member, RayBatch<R, F, I> rays, int first, int end)
    {
        (TriangleMesh mesh, _, int number) = _members[member];
        const int Most = MeshPencil.MostPackets;
        byte* room = stackalloc byte[(Most * sizeof(PencilLanes<R, F, I>)) + CacheLine.Bytes];
        PencilLanes<R, F, I>* lanes = (PencilLanes<R, F, I>*)CacheLine.Start(room);
        byte* crowdRoom = stackalloc byte[MeshCrowd.Bytes];
        MeshCrowd crowd = new(crowdRoom);
        for (int packet = first; packet < end; packet += Most)
        {
            int count = Math.Min(Most, end - packet);
            if (Load(member, rays, rays.Limit, packet, count, lanes))
            {
                MeshHalves.Block(mesh.Data, _trees[member], lanes, count, &crowd, rays, packet, number);
            }
        }

        MeshCrowd.Block(&crowd, mesh.Data, _trees[member], rays, number);
    }

    public override void Surface(
        RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, int* memberOfObject, SurfaceBatch<R, F, I> surfaces, SurfaceNeeds needs)
    {
        if (_members.Count == 1 && !isTransformed && R.Width >= Int4.Width)
        {
            if (R.IsSingle)
            {
                MeshSurfaces<Float4>.Run(_members[0].Mesh.Data, rays, hits, order, count, surfaces, needs);
            }
            else
            {
                MeshSurfaces<Double4>.Run(_members[0].Mesh.Data, rays, hits, order, count, surfaces, needs);
            }

            return;
        }

        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            I members = _members.Count == 1 ? I.Of(0) : I.Gather(memberOfObject, run.Collect(hits.Object));
            int first = I.Get(members, 0);
            SurfaceLanes<R> s;
            if (I.AllEqual(members, first))
            {
                Compute(first, run.Collect(hits.Part), rays, hits, run, out s);
            }
            else
            {
                MergeMembers(members, rays, hits, run, out s);
            }

            surfaces.Store(packet, s, needs);
        }
    }

    public override void Differentiate(
        RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, int* memberOfObject, SurfaceBatch<R, F, I> surfaces, SurfaceSteps<F> steps, StepNeeds needs)
    {
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            I members = _members.Count == 1 ? I.Of(0) : I.Gather(memberOfObject, run.Collect(hits.Object));
            for (int lane = 0; lane < R.Width; lane = NextMember(members, lane))
            {
                int member = I.Get(members, lane);
                I mask = I.Equal(members, I.Of(member));
                LinearLanes<R> frame = LinearLanes<R>.Scaling(R.Of(1), R.Of(1), R.Of(1));
                if (isTransformed)
                {
                    WorldSpace.Linear(Transform(member), out frame);
                }

                I triangle = run.Collect(hits.Part) & mask;
                R a = run.Collect<R, F>(hits.A), b = run.Collect<R, F>(hits.B);
                Differentiate(member, mask, triangle, a, b, frame, packet, surfaces, steps.WorldDx, steps.LocalDx, steps.NormalDx, needs);
                Differentiate(member, mask, triangle, a, b, frame, packet, surfaces, steps.WorldDy, steps.LocalDy, steps.NormalDy, needs);
                if ((needs & StepNeeds.SurfaceGradient) != 0)
                {
                    MeshSteps.SurfaceGradient<R, F, I>(_members[member].Mesh.Data, triangle, out GradientLanes<R> g);
                    F isOwn = R.MaskToSingle(R.MaskFromInt32(mask));
                    steps.SurfaceGradient.U.Merge(packet, isOwn, R.ToSingle(g.UX), R.ToSingle(g.UY), R.ToSingle(g.UZ));
                    steps.SurfaceGradient.V.Merge(packet, isOwn, R.ToSingle(g.VX), R.ToSingle(g.VY), R.ToSingle(g.VZ));
                }
            }
        }
    }

    /// <summary>Rays and limits of some groups of lanes, in object space; false if all rays are off.</summary>
    private bool Load(int member, RayBatch<R, F, I> rays, R* limits, int packet, int count, PencilLanes<R, F, I>* lanes)
    {
        R isOn = R.Zero;
        for (int k = 0; k < count; k++)
        {
            lanes[k].Limit = limits[packet + k];
            isOn |= R.Less(R.Zero, lanes[k].Limit);
        }

        if (!R.Any(isOn))
        {
            return false;
        }

        for (int k = 0; k < count; k++)
        {
            Load(member, rays, packet + k, out lanes[k].Ray);
        }

        return true;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Load(int member, RayBatch<R, F, I> rays, int packet, out RayLanes<R> ray)
    {
        ray = new(
            rays.OriginX[packet], rays.OriginY[packet], rays.OriginZ[packet], rays.DirectionX[packet], rays.DirectionY[packet], rays.DirectionZ[packet]);
        if (isTransformed)
        {
            ray = WorldSpace.ToObject(Transform(member), ray);
        }
    }

    /// <summary>What changes over one step of the lanes of one member.</summary>
    private void Differentiate(
        int member, I mask, I triangle, R a, R b, in LinearLanes<R> frame, int packet, SurfaceBatch<R, F, I> surfaces,
        in VectorColumns<F> world, in VectorColumns<F> local, in VectorColumns<F> normals, StepNeeds needs)
    {
        F isOwn = R.MaskToSingle(R.MaskFromInt32(mask));
        (R X, R Y, R Z) step = frame.Apply(R.FromSingle(world.X[packet]), R.FromSingle(world.Y[packet]), R.FromSingle(world.Z[packet]));
        local.Merge(packet, isOwn, R.ToSingle(step.X), R.ToSingle(step.Y), R.ToSingle(step.Z));
        if ((needs & StepNeeds.Normal) != 0)
        {
            MeshSteps.BendNormal<R, F, I>(_members[member].Mesh.Data, triangle, a, b, step, out NormalLanes<R> normal);
            NormalSteps.Store(frame, normal, surfaces, packet, isOwn, normals);
        }
    }

    /// <summary>The first lane whose member no earlier lane has, or the width.</summary>
    private static int NextMember(in I members, int lane)
    {
        for (lane++; lane < R.Width; lane++)
        {
            bool isNew = true;
            for (int earlier = 0; earlier < lane; earlier++)
            {
                isNew &= I.Get(members, earlier) != I.Get(members, lane);
            }

            if (isNew)
            {
                break;
            }
        }

        return lane;
    }

    /// <summary>Lanes on several meshes: mesh after mesh.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void MergeMembers(in I members, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, in LaneRun<I> run, out SurfaceLanes<R> s)
    {
        s = default;
        for (int lane = 0; lane < R.Width; lane = NextMember(members, lane))
        {
            int member = I.Get(members, lane);
            Merge(member, I.Equal(members, I.Of(member)), rays, hits, run, ref s);
        }
    }

    /// <summary>Surface points on one mesh.</summary>
    private void Compute(int member, in I triangle, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, in LaneRun<I> run, out SurfaceLanes<R> s)
    {
        MeshData mesh = _members[member].Mesh.Data;
        MeshSurface.Compute<R, F, I>(mesh, ToObject(member, rays.Collect(run)), triangle, run.Collect<R, F>(hits.A), run.Collect<R, F>(hits.B), out s);
        if (isTransformed)
        {
            WorldSpace.FromObject(Transform(member), ref s);
        }
    }

    /// <summary>Writes the lanes of one member.</summary>
    private void Merge(int member, in I mask, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, in LaneRun<I> run, ref SurfaceLanes<R> s)
    {
        Compute(member, run.Collect(hits.Part) & mask, rays, hits, run, out SurfaceLanes<R> own);
        s = SurfaceLanes.Select(R.MaskFromInt32(mask), own, s);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private RayLanes<R> ToObject(int member, in RayLanes<R> ray) => isTransformed ? WorldSpace.ToObject(Transform(member), ray) : ray;

    private SharedParameters<R, F, I> Transform(int member) => new(_transforms, member * WorldSpace.ParameterCount);
}
