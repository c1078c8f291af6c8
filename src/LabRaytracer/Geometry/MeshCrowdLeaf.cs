using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Tests rays against the triangles of leaves, one ray against four at a time, which are read and turned once for all rays: the operations of <see cref="MeshSingleLeaf{P}"/>, hence its bits.</summary>
/// <typeparam name="Q">Four lanes of geometry's precision.</typeparam>
/// <typeparam name="R1">One lane of it.</typeparam>
/// <typeparam name="P">How positions are stored.</typeparam>
/// <typeparam name="TSink">What happens to hits.</typeparam>
/// <param name="triangles">The triangles in the order of the leaves.</param>
/// <param name="positions">Their corners.</param>
/// <param name="crowds">The rays for boxes.</param>
/// <param name="crowdRays">The same rays for triangles.</param>
/// <param name="corners">Room for the corners of four triangles, <see cref="Numbers"/>.</param>
/// <param name="sink">What happens to hits.</param>
internal readonly unsafe struct MeshCrowdLeaf<Q, R1, P, TSink>(MeshTriangle* triangles, P positions, BvhCrowd* crowds, MeshCrowdRays* crowdRays, Q* corners, in TSink sink) : IBvhCrowdLeaf
    where Q : unmanaged, IQuad<Q>
    where R1 : unmanaged, ILane<R1, Float1, Int1>
    where P : struct, IMeshPositions
    where TSink : struct, IMeshCrowdSink<R1>
{
    /// <summary>Numbers of a triangle: x, y, z, x, y of each vertex, so that turned axes follow each other.</summary>
    public const int Numbers = 15;

    private const int Vertex = 5;

    private readonly TSink _sink = sink;

    public byte* Items
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (byte*)triangles;
    }

    public void Expect(int first, int last)
    {
        MeshTriangle* a = triangles + first, b = a + Math.Min(1, last), c = a + Math.Min(2, last), d = a + last;
        Expect(a->Element0, b->Element0, c->Element0, d->Element0);
        Expect(a->Element1, b->Element1, c->Element1, d->Element1);
        Expect(a->Element2, b->Element2, c->Element2, d->Element2);
    }

    [SkipLocalsInit]
    public void Visit(int crowd, int first, int count, uint who)
    {
        MeshCrowdRays* rays = crowdRays + crowd;
        MeshTriangle* triangle = triangles + first;
        Read(triangle, count - 1);
        do
        {
            int place = BitOperations.TrailingZeroCount(who);
            who &= who - 1;
            R1* ray = (R1*)rays->Numbers + place;
            Q* turned = corners + rays->Turn[place];
            Q mask = WatertightTriangle.IntersectTurned(
                Of(ray, MeshCrowdRays.OriginX), Of(ray, MeshCrowdRays.OriginY), Of(ray, MeshCrowdRays.OriginZ),
                Of(ray, MeshCrowdRays.ShearX), Of(ray, MeshCrowdRays.ShearY), Of(ray, MeshCrowdRays.ScaleZ),
                turned[0], turned[1], turned[2],
                turned[Vertex], turned[Vertex + 1], turned[Vertex + 2],
                turned[2 * Vertex], turned[(2 * Vertex) + 1], turned[(2 * Vertex) + 2],
                out Q t, out Q weight1, out Q weight2);
            uint hits = Q.Bits(mask & Q.LessOrEqual(t, Of(ray, MeshCrowdRays.Limit))) & ((1u << count) - 1);
            if (hits != 0)
            {
                // Copies: numbers whose addresses are taken would be written for each ray.
                Q ownT = t, own1 = weight1, own2 = weight2;
                Take(crowd, place, triangle, hits, ownT, own1, own2);
            }
        }
        while (who != 0);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Expect(int a, int b, int c, int d)
    {
        positions.Prefetch(a);
        positions.Prefetch(b);
        positions.Prefetch(c);
        positions.Prefetch(d);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Q Of(R1* ray, int column) => Q.Of(R1.Take(ray, column));

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Take(int crowd, int place, MeshTriangle* triangle, uint hits, in Q t, in Q weight1, in Q weight2)
    {
        R1* ray = (R1*)crowdRays[crowd].Numbers + place;
        R1 limit = ray[MeshCrowdRays.Limit];
        bool isLowered = false;
        for (; hits != 0; hits &= hits - 1)
        {
            int lane = BitOperations.TrailingZeroCount(hits);
            R1 own = R1.Of(Q.Get(t, lane));
            if (R1.Any(R1.LessOrEqual(own, limit)))
            {
                isLowered |= _sink.Take((crowd * MeshCrowdRays.Most) + place, own, R1.Of(Q.Get(weight1, lane)), R1.Of(Q.Get(weight2, lane)), triangle[lane].Number, ref limit);
            }
        }

        if (isLowered)
        {
            ray[MeshCrowdRays.Limit] = limit;
            crowds[crowd].Lower(place, (float)Float1.Get(BvhRay<R1, Float1, Int1>.LimitOf(limit, ray[MeshCrowdRays.ToFloat]), 0));
        }
    }

    /// <summary>Four triangles; the last one again where there are fewer.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Read(MeshTriangle* triangle, int last)
    {
        MeshTriangle* b = triangle + Math.Min(1, last), c = triangle + Math.Min(2, last), d = triangle + last;
        Read(corners, triangle->Element0, b->Element0, c->Element0, d->Element0);
        Read(corners + Vertex, triangle->Element1, b->Element1, c->Element1, d->Element1);
        Read(corners + (2 * Vertex), triangle->Element2, b->Element2, c->Element2, d->Element2);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Read(Q* corner, int a, int b, int c, int d)
    {
        Q.Turn(positions.Row<Q>(a), positions.Row<Q>(b), positions.Row<Q>(c), positions.Row<Q>(d), out Q x, out Q y, out Q z);
        corner[0] = x;
        corner[1] = y;
        corner[2] = z;
        corner[3] = x;
        corner[4] = y;
    }
}
