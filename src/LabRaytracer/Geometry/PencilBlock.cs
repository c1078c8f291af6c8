using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Shadow rays of a pencil, whose apex is the lamp: any hit between lamp and surface ends a ray.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
/// <param name="mesh">The mesh.</param>
/// <param name="triangles">Triangles in the order of the tree.</param>
/// <param name="axis">Along which all directions are largest.</param>
/// <param name="rays">The rays; limits of blocked ones become -1.</param>
/// <param name="first">The pencil's first group of lanes there.</param>
/// <param name="number">Number of the mesh's object.</param>
internal readonly unsafe struct PencilBlock<R, F, I>(MeshData mesh, MeshTriangle* triangles, int axis, RayBatch<R, F, I> rays, int first, int number) : IPencilGoal<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const double Rounding = 9.5367431640625e-7;

    public static bool IsOrdered => false;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Leaves(in PencilLanes<R, F, I> lanes, int number) => F.MaskFromInt32(I.Equal(lanes.Triangle, I.Of(number)));

    public void Start(ref PencilLanes<R, F, I> lanes, in RayPencil pencil, int packet)
    {
        lanes.Triangle = rays.SourceIn(first + packet, number);
        F end = R.ToSingle(lanes.Limit * lanes.Pace), slack = F.Of(pencil.LimitError);
        F isOn = R.MaskToSingle(R.Less(R.Zero, lanes.Limit));
        lanes.Far = F.Select(isOn, F.Fma(end, F.Of(1 + Rounding), slack), F.Of(-1));
        lanes.Between = F.Select(isOn, F.Fma(end, F.Of(1 - Rounding), -slack), F.Of(-1));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    [SkipLocalsInit]
    public bool Take(ref PencilLanes<R, F, I> lanes, int packet, in PencilHits<F> found, int place)
    {
        F possible = found.PossibleBefore(lanes.Far);
        possible &= ~Leaves(lanes, triangles[place].Number);
        if (!F.Any(possible))
        {
            return false;
        }

        F blocked = possible & found.Certain & F.LessOrEqual(found.VolumeHigh, lanes.Between * (found.Sum - found.SumError));
        F open = possible & ~blocked;
        if (F.Any(open))
        {
            Decide(ref lanes, open, place, ref blocked);
        }

        lanes.Far = F.Select(blocked, F.Of(-1), lanes.Far);
        lanes.Between = F.Select(blocked, F.Of(-1), lanes.Between);
        return F.Any(blocked);
    }

    public void End(ref PencilLanes<R, F, I> lanes, int packet)
    {
        R limit = rays.Limit[first + packet];
        R isBlocked = R.Less(R.Zero, lanes.Limit) & R.MaskFromSingle(F.Less(lanes.Far, F.Zero));
        rays.Limit[first + packet] = R.Select(isBlocked, R.Of(-1), limit);
    }

    /// <summary>The exact test of one triangle, for some lanes.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Decide(ref PencilLanes<R, F, I> lanes, in F open, int place, ref F blocked)
    {
        PencilTest.Run<R, F, I>(mesh, triangles, axis, lanes.Ray, I.Of(place), out R hit, out R t, out _, out _, out I _);
        blocked |= open & R.MaskToSingle(hit & R.Less(t, lanes.Limit));
    }
}
