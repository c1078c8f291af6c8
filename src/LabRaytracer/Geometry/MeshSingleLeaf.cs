using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Tests one ray against the triangles of leaves, four at a time, and keeps the nearest hit.</summary>
/// <typeparam name="P">How positions are stored.</typeparam>
internal unsafe struct MeshSingleLeaf<P> : IBvhWideLeaf
    where P : struct, IMeshPositions
{
    private readonly MeshTriangle* _triangles;
    private readonly P _positions;
    private readonly WatertightRay<Double4> _ray;
    private readonly MeshNearestSink<Double1, Float1, Int1> _sink;
    private readonly Double1 _toFloat;
    private Double1 _limit;

    /// <param name="triangles">Triangles in the order of the tree.</param>
    /// <param name="positions">Their vertices.</param>
    /// <param name="ray">The ray.</param>
    /// <param name="boxRay">The same, prepared for boxes.</param>
    /// <param name="sink">Keeps the hit.</param>
    public MeshSingleLeaf(
        MeshTriangle* triangles, P positions, in RayLanes<Double1> ray, in BvhRay<Double1, Float1, Int1> boxRay, in MeshNearestSink<Double1, Float1, Int1> sink)
    {
        _triangles = triangles;
        (_positions, _sink) = (positions, sink);
        (_limit, _toFloat) = (boxRay.Limit, boxRay.ToFloat);
        _ray = new WatertightRay<Double4>(new RayLanes<Double4>(
            Double4.Of(ray.OriginX.Value), Double4.Of(ray.OriginY.Value), Double4.Of(ray.OriginZ.Value),
            Double4.Of(ray.DirectionX.Value), Double4.Of(ray.DirectionY.Value), Double4.Of(ray.DirectionZ.Value)));
    }

    /// <summary>The limit in the units of boxes.</summary>
    public readonly float BoxLimit => BvhRay<Double1, Float1, Int1>.LimitOf(_limit, _toFloat).Value;

    public readonly void Expect(int first) => CacheLine.Prefetch(_triangles + first);

    public void Visit(int first, int count, float* box, ref float limit)
    {
        MeshTriangle* triangle = _triangles + first;
        Double4 mask = Intersect(triangle, count - 1, out Double4 t, out Double4 weight1, out Double4 weight2);
        uint hits = Double4.Bits(mask & Double4.LessOrEqual(t, Double4.Of(_limit.Value))) & ((1u << count) - 1);
        if (hits != 0 && Take(triangle, hits, t, weight1, weight2))
        {
            limit = BoxLimit;
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool Take(MeshTriangle* triangle, uint hits, in Double4 t, in Double4 weight1, in Double4 weight2)
    {
        bool isLowered = false;
        for (; hits != 0; hits &= hits - 1)
        {
            int lane = BitOperations.TrailingZeroCount(hits);
            Double1 own = new(Double4.Get(t, lane));
            if (own.Value <= _limit.Value)
            {
                isLowered |= _sink.Take(Double1.True, own, new(Double4.Get(weight1, lane)), new(Double4.Get(weight2, lane)), triangle[lane].Number, ref _limit);
            }
        }

        return isLowered;
    }

    /// <summary>Four triangles; the last one again where there are fewer.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly Double4 Intersect(MeshTriangle* triangle, int last, out Double4 t, out Double4 weight1, out Double4 weight2)
    {
        MeshTriangle* b = triangle + Math.Min(1, last), c = triangle + Math.Min(2, last), d = triangle + last;
        Turn(triangle->Element0, b->Element0, c->Element0, d->Element0, out Double4 x0, out Double4 y0, out Double4 z0);
        Turn(triangle->Element1, b->Element1, c->Element1, d->Element1, out Double4 x1, out Double4 y1, out Double4 z1);
        Turn(triangle->Element2, b->Element2, c->Element2, d->Element2, out Double4 x2, out Double4 y2, out Double4 z2);
        return WatertightTriangle.IntersectTurned(_ray, x0, y0, z0, x1, y1, z1, x2, y2, z2, out t, out weight1, out weight2);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void Turn(int a, int b, int c, int d, out Double4 x, out Double4 y, out Double4 z)
    {
        // All lanes are the same ray, with the same largest axis.
        P p = _positions;
        Double4.Turn(p.Row<Double4>(a), p.Row<Double4>(b), p.Row<Double4>(c), p.Row<Double4>(d), out Double4 first, out Double4 second, out Double4 third);
        (x, y, z) = _ray.SharedAxis == 2 ? (first, second, third) : _ray.SharedAxis == 1 ? (third, first, second) : (second, third, first);
    }
}
