using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Shapes whose formulas are a kernel.</summary>
/// <typeparam name="K">The kernel.</typeparam>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
[SkipLocalsInit]
internal sealed unsafe partial class KernelGroup<K, R, F, I> : ShapeGroup<R, F, I>
    where K : struct, IShapeKernel
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Groups of lanes that are looked at quickly before those that may hit are computed: a bundle, or what is left of it.</summary>
    private const int Looks = RayBatch<R, F, I>.BundlePackets;

    private readonly List<double> _described = [];
    private readonly List<int> _numberOfMember = [];
    private readonly List<double> _looks = [];
    private readonly List<bool> _isQuick = [];
    private R* _numbers;
    private F* _singles;

    public override int Add(Shape shape, Transform transform, int number)
    {
        Span<double> numbers = stackalloc double[K.ParameterCount];
        K.Describe(shape, transform, numbers);
        foreach (double value in numbers)
        {
            _described.Add(value);
        }

        _looks.AddRange(K.HasQuickLook ? numbers : BoundingSphere(shape.Bounds.Transformed(transform)));
        _numberOfMember.Add(number);
        _isQuick.Add(K.IsQuick(numbers));
        return _numberOfMember.Count - 1;
    }

    public override void Freeze(LaneMemory memory, int threads)
    {
        _numbers = memory.Column<R>(_described.Count, R.Width);
        for (int k = 0; k < _described.Count; k++)
        {
            R.Put(_numbers, k, _described[k]);
        }

        _singles = memory.Column<F>(_looks.Count, F.Width);
        for (int k = 0; k < _looks.Count; k++)
        {
            F.Put(_singles, k, _looks[k]);
        }
    }

    public override void Nearest(int member, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int first, int end)
    {
        SharedParameters<R, F, I> shape = new(_numbers, member * K.ParameterCount);
        int number = _numberOfMember[member];
        if (_isQuick[member])
        {
            NearestQuick(shape, number, rays, hits, first, end);
            return;
        }

        int* seen = stackalloc int[Looks];
        for (int from = first; from < end; from = EndOfLook(from, end))
        {
            int count = Look(member, rays, from, EndOfLook(from, end), seen);
            for (int k = 0; k < count; k++)
            {
                if (!(K.IsConvex && I.AllEqual(rays.Source[seen[k]], number)))
                {
                    RayLanes<R> ray = rays.Load(seen[k]);
                    R mask = K.Intersect(shape, ray, out R t);
                    hits.Keep(seen[k], mask, t, number);
                }
            }
        }
    }

    public override void Block(int member, RayBatch<R, F, I> rays, int first, int end)
    {
        SharedParameters<R, F, I> shape = new(_numbers, member * K.ParameterCount);
        int number = _numberOfMember[member];
        if (K.IsConvex && rays.CommonSource == number)
        {
            return;
        }

        if (_isQuick[member])
        {
            BlockQuick(shape, number, rays, first, end);
            return;
        }

        int* seen = stackalloc int[Looks];
        for (int from = first; from < end; from = EndOfLook(from, end))
        {
            int count = Look(member, rays, from, EndOfLook(from, end), seen);
            for (int k = 0; k < count; k++)
            {
                int packet = seen[k];
                R limit = rays.Limit[packet];
                if (R.Any(R.Less(R.Zero, limit)) && !(K.IsConvex && I.AllEqual(rays.Source[packet], number)))
                {
                    RayLanes<R> ray = rays.Load(packet);
                    R mask = K.Intersect(shape, ray, out R t) & R.Less(t, limit);
                    rays.Limit[packet] = R.Select(mask, R.Of(-1), limit);
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void NearestQuick(SharedParameters<R, F, I> shape, int number, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int first, int end)
    {
        RayColumns<R> columns = rays.Columns;
        for (int packet = first; packet < end; packet++)
        {
            R mask = K.IntersectQuick(shape, columns, packet, out R t);
            if (R.Any(mask))
            {
                hits.Keep(packet, mask, t, number);
            }
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void BlockQuick(SharedParameters<R, F, I> shape, int number, RayBatch<R, F, I> rays, int first, int end)
    {
        RayColumns<R> columns = rays.Columns;
        for (int packet = first; packet < end; packet++)
        {
            R limit = rays.Limit[packet];
            if (R.Any(R.Less(R.Zero, limit)) && !(K.IsConvex && I.AllEqual(rays.Source[packet], number)))
            {
                R mask = K.IntersectQuick(shape, columns, packet, out R t) & R.Less(t, limit);
                rays.Limit[packet] = R.Select(mask, R.Of(-1), limit);
            }
        }
    }

    public override void Surface(
        RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, int* memberOfObject, SurfaceBatch<R, F, I> surfaces, SurfaceNeeds needs)
    {
        if (K.IsSmooth && (needs & SurfaceNeeds.Sharp) == 0)
        {
            surfaces.SharesNormals = true;
            int* members = _numberOfMember.Count == 1 ? null : memberOfObject;
            hits.Refined += SmoothSurface<K>.Run<R, F, I>(rays.Columns, hits.T, hits.Object, _numbers, members, order, count, surfaces.Columns, needs);
            return;
        }

        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            RayLanes<R> ray = rays.Collect(run);
            R found = run.Collect<R, F>(hits.T), t = found;
            SurfaceLanes<R> s;
            if (_numberOfMember.Count == 1)
            {
                Surface(new SharedParameters<R, F, I>(_numbers, 0), ray, ref t, out s, needs);
            }
            else
            {
                int one = ((int*)hits.Object)[run.First];
                I number = run.Collect(hits.Object);
                if (I.AllEqual(number, one))
                {
                    Surface(new SharedParameters<R, F, I>(_numbers, memberOfObject[one] * K.ParameterCount), ray, ref t, out s, needs);
                }
                else
                {
                    I first = I.Gather(memberOfObject, number) * I.Of(K.ParameterCount);
                    Surface(new GatheredParameters<R, F, I>(_numbers, first), ray, ref t, out s, needs);
                }
            }

            surfaces.Store(packet, s, needs);
            if (!R.All(R.Equal(t, found)))
            {
                KeepRefined(hits, order, count, packet, t);
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Surface<P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s, SurfaceNeeds needs)
        where P : struct, IParameters<R>
    {
        K.Surface(shape, ray, ref t, out s);
        if ((needs & SurfaceNeeds.Sharp) != 0)
        {
            K.Sharpen(shape, ray, ref t, ref s);
        }
    }

    public override void Differentiate(
        RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, int* memberOfObject, SurfaceBatch<R, F, I> surfaces, SurfaceSteps<F> steps, StepNeeds needs)
    {
        LinearLanes<F> frame = default;
        if (_numberOfMember.Count == 1)
        {
            SharedParameters<R, F, I> only = new(_numbers, 0);
            KernelSteps<K, R, F, I>.Frame(only, out frame);
            KernelSteps<K, R, F, I>.Run(only, frame, 0, (count + R.Width - 1) / R.Width, surfaces, steps, needs);
            return;
        }

        int known = -1;
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            int one = ((int*)hits.Object)[run.First];
            I number = run.Collect(hits.Object);
            if (I.AllEqual(number, one))
            {
                int member = memberOfObject[one];
                SharedParameters<R, F, I> shape = new(_numbers, member * K.ParameterCount);
                if (member != known)
                {
                    KernelSteps<K, R, F, I>.Frame(shape, out frame);
                    known = member;
                }

                KernelSteps<K, R, F, I>.Run(shape, frame, packet, packet + 1, surfaces, steps, needs);
            }
            else
            {
                I first = I.Gather(memberOfObject, number) * I.Of(K.ParameterCount);
                GatheredParameters<R, F, I> shapes = new(_numbers, first);
                KernelSteps<K, R, F, I>.Frame(shapes, out frame);
                known = -1;
                KernelSteps<K, R, F, I>.Run(shapes, frame, packet, packet + 1, surfaces, steps, needs);
            }
        }
    }

    private static void KeepRefined(HitBatch<R, F, I> hits, int* order, int count, int packet, R t)
    {
        int first = packet * R.Width;
        for (int lane = 0; lane < R.Width && first + lane < count; lane++)
        {
            double refined = R.Get(t, lane);
            hits.Refined += refined == R.Take(hits.T, order[first + lane]) ? 0 : 1;
            R.Put(hits.T, order[first + lane], refined);
        }
    }
}
