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
/// <param name="parts">The bounds of its groups of lanes (<see cref="PencilParts"/>).</param>
/// <param name="goal">What the rays look for.</param>
internal readonly unsafe struct PencilLeaf<R, F, I, P, TGoal>(
    in RayPencil pencil, PencilLanes<R, F, I>* lanes, int count, MeshTriangle* triangles, P positions, float* columns, F* parts, in TGoal goal) : IBvhWideLeaf
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
    where P : struct, IMeshPositions
    where TGoal : struct, IPencilGoal<R, F, I>
{
    private readonly RayPencil _pencil = pencil;
    private readonly TGoal _goal = goal;

    private float LargestLimit
    {
        get
        {
            F largest = lanes->Far;
            for (int packet = 1; packet < count; packet++)
            {
                largest = F.Max(largest, lanes[packet].Far);
            }

            return (float)F.Largest(largest);
        }
    }

    /// <summary>Sets the limits.</summary>
    /// <returns>The largest one.</returns>
    public float Start()
    {
        for (int packet = 0; packet < count; packet++)
        {
            _goal.Start(ref lanes[packet], _pencil, packet);
        }

        return LargestLimit;
    }

    public void Expect(int first) => CacheLine.Prefetch(triangles + first);

    public void Visit(int first, int number, float* box, ref float limit)
    {
        bool isLowered = false;
        uint left = PencilTriangles.Prepare<R, P>(_pencil, triangles + first, number, positions, columns);
        for (int group = 0; left != 0 && group < PencilParts.Groups<F>(count); group++)
        {
            uint met = PencilParts.Meet(parts + (PencilParts.Numbers * group), columns, left, group);
            for (; met != 0; met &= met - 1)
            {
                uint pair = (uint)((group * F.Width) + BitOperations.TrailingZeroCount(met)), packet = pair / PencilTriangles.Most, triangle = pair % PencilTriangles.Most;
                isLowered |= Test(ref lanes[packet], (int)packet, columns + triangle, first + (int)triangle);
            }
        }

        if (isLowered)
        {
            limit = LargestLimit;
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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    [SkipLocalsInit]
    private bool Test(ref PencilLanes<R, F, I> own, int packet, float* triangle, int place)
    {
        F edge0 = Edge(own, triangle, 0), edge1 = Edge(own, triangle, 1), edge2 = Edge(own, triangle, 2);
        F possible = F.LessOrEqual(F.Zero, F.Min(F.Min(edge0, edge1), edge2));
        if (!F.Any(possible))
        {
            return false;
        }

        Unsafe.SkipInit(out PencilHits<F> hits);
        hits.Possible = possible;
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
