using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Leaves of a mesh's tree for a pencil of rays: edge functions in floats decide, where their error bounds allow it.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
/// <typeparam name="P">How positions are stored.</typeparam>
/// <typeparam name="TGoal">What the rays look for.</typeparam>
/// <param name="pencil">The pencil.</param>
/// <param name="lanes">Its groups of lanes; they stay where they are.</param>
/// <param name="count">How many groups.</param>
/// <param name="triangles">Triangles in the order of the tree.</param>
/// <param name="positions">Their vertices.</param>
/// <param name="columns">Room for what <see cref="PencilTriangles"/> prepares.</param>
/// <param name="parts">Where its groups of lanes look.</param>
/// <param name="goal">What the rays look for.</param>
internal readonly unsafe struct PencilLeaf<R, F, I, P, TGoal>(
    in RayPencil pencil, PencilLanes<R, F, I>* lanes, int count, MeshTriangle* triangles, P positions, float* columns, in PencilParts<F, I> parts, in TGoal goal) : IBvhWideLeaf
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
    where P : struct, IMeshPositions
    where TGoal : struct, IPencilGoal<R, F, I>
{
    private readonly RayPencil _pencil = pencil;
    private readonly PencilParts<F, I> _parts = parts;
    private readonly TGoal _goal = goal;

    public static bool IsOrdered => TGoal.IsOrdered;

    /// <summary>Sets the limits.</summary>
    /// <returns>The largest one.</returns>
    public float Start()
    {
        for (int packet = 0; packet < count; packet++)
        {
            _goal.Start(ref lanes[packet], _pencil, packet);
        }

        return LowerLimits((1u << count) - 1);
    }

    public void Expect(int first) => CacheLine.Prefetch(triangles + first);

    public void Visit(int first, int number, float* box, ref float limit)
    {
        uint parts = _parts.Meet(box);
        if (parts == 0)
        {
            return;
        }

        uint left = PencilTriangles.Prepare<R, P>(_pencil, triangles + first, number, positions, columns);
        if (left == 0)
        {
            return;
        }

        uint lowered = 0;
        for (ulong pairs = Possible(_parts.Pairs(columns, left, parts)); pairs != 0; pairs &= pairs - 1)
        {
            int pair = BitOperations.TrailingZeroCount(pairs), packet = PencilParts<F, I>.PartOf(pair), triangle = PencilParts<F, I>.TriangleOf(pair);
            lowered |= Test(ref lanes[packet], packet, columns + triangle, first + triangle) ? 1u << packet : 0;
        }

        if (lowered != 0)
        {
            limit = LowerLimits(lowered);
        }
    }

    /// <summary>Brings what was found into its final form.</summary>
    public void End()
    {
        for (int packet = 0; packet < count; packet++)
        {
            _goal.End(ref lanes[packet], packet);
        }
    }

    /// <summary>Sets how far parts look whose limits were lowered.</summary>
    /// <returns>The largest limit of all parts.</returns>
    private float LowerLimits(uint lowered)
    {
        for (; lowered != 0; lowered &= lowered - 1)
        {
            int packet = BitOperations.TrailingZeroCount(lowered);
            _parts.SetFar(packet, (float)F.Largest(lanes[packet].Far));
        }

        return _parts.LargestFar;
    }

    /// <summary>Bits of the pairs of which some ray may hit the triangle within its limit. No branch depends on it, as a third of them do, in no order.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private ulong Possible(ulong pairs)
    {
        ulong possible = 0;
        for (; pairs != 0; pairs &= pairs - 1)
        {
            int pair = BitOperations.TrailingZeroCount(pairs);
            PencilLanes<R, F, I>* own = lanes + PencilParts<F, I>.PartOf(pair);
            float* triangle = columns + PencilParts<F, I>.TriangleOf(pair);
            F edge0 = Edge(*own, triangle, 0), edge1 = Edge(*own, triangle, 1), edge2 = Edge(*own, triangle, 2);
            F isInside = F.LessOrEqual(F.Zero, F.Min(F.Min(edge0, edge1), edge2));
            F isBefore = F.LessOrEqual(At(triangle, PencilTriangles.VolumeLow), own->Far * (edge0 + edge1 + edge2));

            // 1 where any bit is set.
            ulong any = (0UL - F.Bits(isInside & isBefore)) >> 63;
            possible |= any << pair;
        }

        return possible;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    [SkipLocalsInit]
    private bool Test(ref PencilLanes<R, F, I> own, int packet, float* triangle, int place)
    {
        F edge0 = Edge(own, triangle, 0), edge1 = Edge(own, triangle, 1), edge2 = Edge(own, triangle, 2);
        Unsafe.SkipInit(out PencilHits<F> hits);
        hits.Possible = F.LessOrEqual(F.Zero, F.Min(F.Min(edge0, edge1), edge2));
        hits.SumError = At(triangle, PencilTriangles.SumError);
        hits.Sum = edge0 + edge1 + edge2;
        F inside = F.Min(F.Min(edge0 - Error(triangle, 0), edge1 - Error(triangle, 1)), edge2 - Error(triangle, 2));
        hits.Certain = F.Less(F.Zero, inside);
        hits.VolumeLow = At(triangle, PencilTriangles.VolumeLow);
        hits.VolumeHigh = At(triangle, PencilTriangles.VolumeHigh);

        // Without a copy, which a method of a read-only field may not need.
        return Unsafe.AsRef(in _goal).Take(ref own, packet, hits, place);
    }

    /// <summary>An edge function, raised by its error bound.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Edge(in PencilLanes<R, F, I> own, float* triangle, int edge) => F.Fma(
        own.SlopeX, At(triangle, (edge * PencilTriangles.EdgeNumbers) + PencilTriangles.EdgeX),
        F.Fma(own.SlopeY, At(triangle, (edge * PencilTriangles.EdgeNumbers) + PencilTriangles.EdgeY), At(triangle, (edge * PencilTriangles.EdgeNumbers) + PencilTriangles.EdgeMiddle)));

    /// <summary>Twice the error bound of an edge function.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Error(float* triangle, int edge) => At(triangle, (edge * PencilTriangles.EdgeNumbers) + PencilTriangles.EdgeError);

    /// <summary>A prepared number of a triangle, in every lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F At(float* triangle, int number) => F.Broadcast((F*)triangle, number * PencilTriangles.Most);
}
