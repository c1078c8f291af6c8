using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Tests one ray against the triangles of leaves, four at a time.</summary>
/// <typeparam name="Q">Four lanes of geometry's precision.</typeparam>
/// <typeparam name="R1">One lane of it.</typeparam>
/// <typeparam name="P">How positions are stored.</typeparam>
/// <typeparam name="TSink">What happens to hits.</typeparam>
internal unsafe struct MeshSingleLeaf<Q, R1, P, TSink>(MeshTriangle* triangles, P positions) : IBvhWideLeaf
    where Q : unmanaged, IQuad<Q>
    where R1 : unmanaged, ILane<R1, Float1, Int1>
    where P : struct, IMeshPositions
    where TSink : struct, IMeshSink<R1>
{
    /// <summary>What was found.</summary>
    public TSink Sink;

    private RayLanes<Q> _source;
    private R1 _toFloat;
    private R1 _limit;
    private WatertightRay<Q> _ray;
    private bool _isPrepared;

    /// <summary>Goes on with another ray, one lane of a group.</summary>
    /// <returns>The ray's limit in the units of boxes.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Aim<R, F, I>(in RayLanes<R> ray, in BvhRay<R, F, I> boxRay, int lane)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        _source = new RayLanes<Q>(
            Q.Of(Get(ray.OriginX, lane)), Q.Of(Get(ray.OriginY, lane)), Q.Of(Get(ray.OriginZ, lane)),
            Q.Of(Get(ray.DirectionX, lane)), Q.Of(Get(ray.DirectionY, lane)), Q.Of(Get(ray.DirectionZ, lane)));
        _limit = R1.Of(Get(boxRay.Limit, lane));
        _toFloat = R1.Of(Get(boxRay.ToFloat, lane));
        _isPrepared = false;
        return (float)Float1.Get(BvhRay<R1, Float1, Int1>.LimitOf(_limit, _toFloat), 0);
    }

    public static bool IsOrdered => true;

    public void Expect(int first) => CacheLine.Prefetch(triangles + first);

    public void Visit(int first, int count, float* box, ref float limit)
    {
        if (!_isPrepared)
        {
            _ray = new WatertightRay<Q>(_source);
            _isPrepared = true;
        }

        MeshTriangle* triangle = triangles + first;
        Q mask = Intersect(triangle, count - 1, out Q t, out Q weight1, out Q weight2);
        uint hits = Q.Bits(mask & Q.LessOrEqual(t, Q.Of(R1.Get(_limit, 0)))) & ((1u << count) - 1);
        if (hits != 0 && Take(triangle, hits, t, weight1, weight2))
        {
            limit = (float)Float1.Get(BvhRay<R1, Float1, Int1>.LimitOf(_limit, _toFloat), 0);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Get<R>(in R lanes, int lane)
        where R : unmanaged, IReal<R> => Lane.Take((R*)Unsafe.AsPointer(ref Unsafe.AsRef(in lanes)), lane);

    [MethodImpl(MethodImplOptions.NoInlining)]
    private bool Take(MeshTriangle* triangle, uint hits, in Q t, in Q weight1, in Q weight2)
    {
        bool isLowered = false;
        for (; hits != 0; hits &= hits - 1)
        {
            int lane = BitOperations.TrailingZeroCount(hits);
            R1 own = R1.Of(Q.Get(t, lane));
            if (R1.Any(R1.LessOrEqual(own, _limit)))
            {
                isLowered |= Sink.Take(R1.True, own, R1.Of(Q.Get(weight1, lane)), R1.Of(Q.Get(weight2, lane)), triangle[lane].Number, ref _limit);
            }
        }

        return isLowered;
    }

    /// <summary>Four triangles; the last one again where there are fewer.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly Q Intersect(MeshTriangle* triangle, int last, out Q t, out Q weight1, out Q weight2)
    {
        MeshTriangle* b = triangle + Math.Min(1, last), c = triangle + Math.Min(2, last), d = triangle + last;
        Turn(triangle->Element0, b->Element0, c->Element0, d->Element0, out Q x0, out Q y0, out Q z0);
        Turn(triangle->Element1, b->Element1, c->Element1, d->Element1, out Q x1, out Q y1, out Q z1);
        Turn(triangle->Element2, b->Element2, c->Element2, d->Element2, out Q x2, out Q y2, out Q z2);
        return WatertightTriangle.IntersectTurned(_ray, x0, y0, z0, x1, y1, z1, x2, y2, z2, out t, out weight1, out weight2);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void Turn(int a, int b, int c, int d, out Q x, out Q y, out Q z)
    {
        // All lanes are the same ray, with the same largest axis.
        Q.Turn(positions.Row<Q>(a), positions.Row<Q>(b), positions.Row<Q>(c), positions.Row<Q>(d), out Q first, out Q second, out Q third);
        (x, y, z) = _ray.SharedAxis == 2 ? (first, second, third) : _ray.SharedAxis == 1 ? (third, first, second) : (second, third, first);
    }
}
