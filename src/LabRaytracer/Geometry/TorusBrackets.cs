using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Five places along rays, between which the quartic of a torus is monotone: its extrema and the ends of the part inside the bounding sphere.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal struct TorusBrackets<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Mask: the ray passes through the bounding sphere, ahead of its origin.</summary>
    public readonly R IsNear;

    /// <summary>Mask: whether one of the places is inside of the tube is too close to be certain.</summary>
    public readonly R IsClose;

    private readonly R _first, _second, _third, _fourth, _last;
    private readonly R _uncertainty;
    private R _outsideFirst, _outsideSecond, _outsideThird, _outsideFourth;

    /// <param name="line">The rays.</param>
    /// <param name="k">Ray parameter of their nearest points.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public TorusBrackets(in TorusLine<R> line, in R k)
    {
        // The sphere is a little too large, so that its surface is outside of the tube.
        R reach = (line.Tube + R.Of(1)) * R.Of(1.000001);
        R square = R.Fma(reach, reach, -line.DistanceSquared);
        R half = R.Sqrt(R.Max(square, R.Zero));
        _last = half;
        _first = R.Max(-half, line.Tau(-k));
        IsNear = R.LessOrEqual(R.Zero, square) & R.Less(_first, _last);
        (R p, R q) = line.Extrema();
        R turn = R.Sqrt(R.Max(p * R.Of(-1.0 / 3), R.Zero));
        R left = R.Min(R.Max(-turn, _first), _last), right = R.Min(R.Max(turn, _first), _last);
        _second = TorusRoot.Cubic(p, q, IsNear, _first, left);
        _third = TorusRoot.Cubic(p, q, IsNear, left, right);
        _fourth = TorusRoot.Cubic(p, q, IsNear, right, _last);
        _outsideFirst = line.Outside(_first, out _);
        _outsideSecond = line.Outside(_second, out _);
        _outsideThird = line.Outside(_third, out _);
        _outsideFourth = line.Outside(_fourth, out _);
        _uncertainty = line.Tube * R.Of(R.IsSingle ? 32.0 / (1 << 24) : 32.0 / (1L << 53));
        R closest = R.Min(R.Min(R.Abs(_outsideFirst), R.Abs(_outsideSecond)), R.Min(R.Abs(_outsideThird), R.Abs(_outsideFourth)));
        IsClose = IsNear & R.LessOrEqual(closest, _uncertainty);
    }

    /// <summary>Decides the places that are close with twice the digits.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Decide(in TorusLine<R> line, in PreciseLine<R> precise, in RayLanes<R> ray, in R ring, in R tube)
    {
        _outsideFirst = Decided(_outsideFirst, line.Along(_first), precise, ray, ring, tube);
        _outsideSecond = Decided(_outsideSecond, line.Along(_second), precise, ray, ring, tube);
        _outsideThird = Decided(_outsideThird, line.Along(_third), precise, ray, ring, tube);
        _outsideFourth = Decided(_outsideFourth, line.Along(_fourth), precise, ray, ring, tube);
    }

    /// <summary>The first pair of places of which one is inside of the tube and the other outside; returns the mask of rays that have one.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public readonly R First(out R low, out R high, out R startsInside)
    {
        R first = R.LessOrEqual(_outsideFirst, R.Zero), second = R.LessOrEqual(_outsideSecond, R.Zero);
        R third = R.LessOrEqual(_outsideThird, R.Zero), fourth = R.LessOrEqual(_outsideFourth, R.Zero);
        (low, high, startsInside) = (_fourth, _last, fourth);
        R hit = fourth;
        Take(third ^ fourth, _third, _fourth, third, ref hit, ref low, ref high, ref startsInside);
        Take(second ^ third, _second, _third, second, ref hit, ref low, ref high, ref startsInside);
        Take(first ^ second, _first, _second, first, ref hit, ref low, ref high, ref startsInside);
        return hit & IsNear;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Take(R mask, R from, R to, R isInside, ref R hit, ref R low, ref R high, ref R startsInside)
    {
        hit |= mask;
        low = R.Select(mask, from, low);
        high = R.Select(mask, to, high);
        startsInside = R.Select(mask, isInside, startsInside);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly R Decided(in R outside, in R along, in PreciseLine<R> line, in RayLanes<R> ray, in R ring, in R tube) =>
        R.Select(R.LessOrEqual(R.Abs(outside), _uncertainty), PreciseTorusHit<R>.Outside(line, ray, ring, tube, new DoubleWord<R>(along, R.Zero)), outside);
}
