using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Leaves of a mesh's tree for a pencil of rays: edge functions in floats decide, where their error bounds allow it.</summary>
/// <remarks>Leaves wait for each other: what is done for four of them takes as many instructions as for one, and loops end less often where nobody expects it.</remarks>
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
/// <param name="vertices">Room for vertices.</param>
/// <param name="columns">Room for what <see cref="PencilTriangles"/> prepares.</param>
/// <param name="queue">Leaves that wait.</param>
/// <param name="parts">Where its groups of lanes look.</param>
/// <param name="goal">What the rays look for.</param>
internal unsafe struct PencilLeaf<R, F, I, P, TGoal>(
    in RayPencil pencil, PencilLanes<R, F, I>* lanes, int count, MeshTriangle* triangles, P positions, float* vertices, float* columns, PencilQueue* queue, in PencilParts<F, I> parts, in TGoal goal) : IBvhWideLeaf
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
    where P : struct, IMeshPositions
    where TGoal : struct, IPencilGoal<R, F, I>
{
    /// <summary>Most leaves that two rays are worth: about what they take on their own.</summary>
    private const int LeavesOfTwoRays = 5;

    private readonly RayPencil _pencil = pencil;
    private readonly PencilParts<F, I> _parts = parts;
    private readonly TGoal _goal = goal;
    private int _left = pencil.Rays * LeavesOfTwoRays / 2;

    /// <summary>Tells whether the search ended early: for the size of the triangles, the rays are too far from each other, as those of a small picture, or those to a lamp from what mirrors show.</summary>
    public readonly bool IsTooWide => _left < 0;

    /// <summary>Sets the limits.</summary>
    /// <returns>The largest one.</returns>
    public readonly float Start()
    {
        for (int packet = 0; packet < count; packet++)
        {
            _goal.Start(ref lanes[packet], _pencil, packet);
        }

        return LowerLimits((1u << count) - 1);
    }

    public void Expect(int first)
    {
        // Seldom in one line.
        CacheLine.Prefetch(triangles + first);
        CacheLine.Prefetch(triangles + first + PencilTriangles.Most - 1);
    }

    public void Visit(int first, int number, float* box, ref float limit)
    {
        if (--_left < 0)
        {
            limit = -1;
            return;
        }

        queue->Add(first, number, _parts.Meet(box));
        if (queue->Leaves == PencilQueue.Most)
        {
            Flush(ref limit);
        }
    }

    /// <summary>Tests the leaves that still wait, and brings what was found into its final form.</summary>
    public void End()
    {
        float limit = 0;
        Flush(ref limit);
        for (int packet = 0; packet < count; packet++)
        {
            _goal.End(ref lanes[packet], packet);
        }
    }

    /// <summary>Tests the leaves that wait.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Flush(ref float limit)
    {
        int prepared = queue->Leaves * PencilTriangles.Most;
        for (int leaf = 0; leaf < queue->Leaves; leaf++)
        {
            PencilTriangles.Load(_pencil, triangles + queue->First[leaf], queue->Count[leaf], positions, vertices + (PencilTriangles.Most * leaf));
        }

        for (int first = 0; first < prepared; first += F.Width)
        {
            PencilTriangles.Prepare<F>(_pencil, R.IsSingle, Math.Min(prepared - first, F.Width), vertices + first, columns + first);
        }

        _parts.FindPairs(queue, columns);
        FindHits();
        uint lowered = 0;
        for (int k = 0; k < queue->Hits; k++)
        {
            int packet = PencilQueue.PartOf(queue->Hit[k]), triangle = PencilQueue.PlaceOf(queue->Hit[k]);
            lowered |= Test(ref lanes[packet], packet, columns + triangle, PlaceOf(triangle)) ? 1u << packet : 0;
        }

        queue->Clear();
        if (lowered != 0)
        {
            limit = LowerLimits(lowered);
        }
    }

    /// <summary>Sets how far parts look whose limits were lowered.</summary>
    /// <returns>The largest limit of all parts.</returns>
    private readonly float LowerLimits(uint lowered)
    {
        for (; lowered != 0; lowered &= lowered - 1)
        {
            int packet = BitOperations.TrailingZeroCount(lowered);
            _parts.SetFar(packet, (float)F.Largest(lanes[packet].Far));
        }

        return _parts.LargestFar;
    }

    /// <summary>Lists the pairs of which some ray may hit the triangle within its limit. No branch depends on it, as half of them do, in no order, nor on where a group of pairs ends.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly void FindHits()
    {
        PencilQueue* own = queue;
        int hits = 0, group = 0, pairs = own->Pairs;
        uint bits = own->Bits[0];
        for (int k = 0; k < pairs; k++)
        {
            int bit = BitOperations.TrailingZeroCount(bits), from = own->From[group];
            int packet = PencilQueue.PartOf(from) + (bit / PencilTriangles.Most), triangle = (PencilQueue.PlaceOf(from) * PencilTriangles.Most) + (bit % PencilTriangles.Most);
            PencilLanes<R, F, I>* rays = lanes + packet;
            float* numbers = columns + triangle;
            F edge0 = Edge(*rays, numbers, 0), edge1 = Edge(*rays, numbers, 1), edge2 = Edge(*rays, numbers, 2);
            F isInside = F.LessOrEqual(F.Zero, F.Min(F.Min(edge0, edge1), edge2));
            F isBefore = F.LessOrEqual(At(numbers, PencilTriangles.VolumeLow), rays->Far * (edge0 + edge1 + edge2));
            F isOther = ~TGoal.Leaves(*rays, triangles[PlaceOf(triangle)].Number);
            own->Hit[hits] = PencilQueue.Of(triangle, packet);

            // 1 where any bit is set.
            hits += (int)((0UL - F.Bits(isInside & isBefore & isOther)) >> 63);
            bits &= bits - 1;
            uint isLast = (uint)((bits - 1UL) >> 63);
            group += (int)isLast;
            bits |= own->Bits[group] & (0 - isLast);
        }

        own->Hits = hits;
    }

    /// <summary>Place in the tree of a prepared triangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly int PlaceOf(int triangle) => queue->First[triangle / PencilTriangles.Most] + (triangle % PencilTriangles.Most);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    [SkipLocalsInit]
    private readonly bool Test(ref PencilLanes<R, F, I> own, int packet, float* triangle, int place)
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
    private static F At(float* triangle, int number) => F.Broadcast((F*)triangle, number * PencilTriangles.Room);
}
