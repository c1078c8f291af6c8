using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Nearest hits of a pencil of rays. A triangle that is certainly hit, and certainly nearer than what was found before, is only remembered: the exact test follows once a ray, at the end.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
/// <param name="mesh">The mesh.</param>
/// <param name="triangles">Triangles in the order of the tree.</param>
/// <param name="axis">Along which all directions are largest.</param>
/// <param name="hits">Receives the hits.</param>
/// <param name="first">The pencil's first group of lanes there.</param>
/// <param name="number">Number of the mesh's object.</param>
internal readonly unsafe struct PencilNearest<R, F, I>(MeshData mesh, MeshTriangle* triangles, int axis, HitBatch<R, F, I> hits, int first, int number) : IPencilGoal<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const double AboveRounding = 1 + 9.5367431640625e-7;

    public static bool IsOrdered => true;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Leaves(in PencilLanes<R, F, I> lanes, int number) => F.Zero;

    public void Start(ref PencilLanes<R, F, I> lanes, in RayPencil pencil, int packet)
    {
        lanes.Far = F.Of(8 * pencil.Size);
        lanes.Triangle = I.Of(-1);
        SetFar(ref lanes);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    [SkipLocalsInit]
    public bool Take(ref PencilLanes<R, F, I> lanes, int packet, in PencilHits<F> found, int place)
    {
        F far = lanes.Far;
        F possible = found.PossibleBefore(far);
        if (!F.Any(possible))
        {
            return false;
        }

        F end = found.VolumeHigh / F.Max(found.Sum - found.SumError, F.Zero);
        F start = found.VolumeLow / found.Sum;
        F takes = possible & found.Certain & F.Less(end, lanes.Between);
        I takesIndex = F.MaskToInt32(takes);
        lanes.Far = F.Select(takes, end, far);
        lanes.Between = F.Select(takes, start, lanes.Between);
        lanes.Triangle = I.Select(takesIndex, I.Of(place), lanes.Triangle);
        F open = possible & ~takes;

        if (F.Any(open))
        {
            Decide(ref lanes, packet, open, place);
        }

        return true;
    }

    public void End(ref PencilLanes<R, F, I> lanes, int packet) => Resolve(ref lanes, packet);

    /// <summary>The exact test of one triangle, for some lanes.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Decide(ref PencilLanes<R, F, I> lanes, int packet, in F open, int place)
    {
        Resolve(ref lanes, packet);
        Test(ref lanes, packet, R.MaskFromSingle(open), I.Of(place));
        SetFar(ref lanes);
    }

    /// <summary>The exact test of the triangles that were remembered.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Resolve(ref PencilLanes<R, F, I> lanes, int packet)
    {
        I isFound = I.Less(I.Of(-1), lanes.Triangle);
        R mask = R.MaskFromInt32(isFound);
        if (R.Any(mask))
        {
            Test(ref lanes, packet, mask, lanes.Triangle & isFound);
            lanes.Triangle = I.Of(-1);
        }
    }

    private void Test(ref PencilLanes<R, F, I> lanes, int packet, in R mask, in I place)
    {
        PencilTest.Run<R, F, I>(mesh, triangles, axis, lanes.Ray, place, out R hit, out R t, out R weight1, out R weight2, out I part);
        hit &= mask & R.LessOrEqual(t, lanes.Limit);
        if (R.Any(hit))
        {
            MeshNearestSink<R, F, I> sink = new(hits, first + packet, number);
            sink.Take(hit, t, weight1, weight2, part, ref lanes.Limit);
        }
    }

    /// <summary>Lowers what matters along z to the exact limits.</summary>
    private static void SetFar(ref PencilLanes<R, F, I> lanes) =>
        lanes.Far = lanes.Between = F.Min(R.ToSingle(lanes.Limit * lanes.Pace) * F.Of(AboveRounding), lanes.Far);
}
