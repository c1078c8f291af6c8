using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A point of checkers, or one number for each of their axes.</summary>
internal struct CheckerPoint<R>
    where R : unmanaged, IReal<R>
{
    public R U, V, W;
}

/// <summary>The sides of footprints in cells, the longer one told apart. In texture space W is 0.</summary>
internal readonly struct CheckerSides<R>
    where R : unmanaged, IReal<R>
{
    public readonly R LongU, LongV, LongW, ShortU, ShortV, ShortW;

    /// <param name="x">Step to the sample at the right, cells.</param>
    /// <param name="y">Step to the sample below, cells.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public CheckerSides(in CheckerPoint<R> x, in CheckerPoint<R> y)
    {
        R xU = CheckerArea.Bound(x.U), xV = CheckerArea.Bound(x.V), xW = CheckerArea.Bound(x.W);
        R yU = CheckerArea.Bound(y.U), yV = CheckerArea.Bound(y.V), yW = CheckerArea.Bound(y.W);
        R isX = R.Less(Square(yU, yV, yW), Square(xU, xV, xW));
        LongU = R.Select(isX, xU, yU);
        LongV = R.Select(isX, xV, yV);
        LongW = R.Select(isX, xW, yW);
        ShortU = R.Select(isX, yU, xU);
        ShortV = R.Select(isX, yV, xV);
        ShortW = R.Select(isX, yW, xW);
    }

    /// <summary>Into how many pieces the longer side is cut: each at most a quarter of a cell long along each axis.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public R Pieces()
    {
        R longest = R.Max(R.Abs(LongU), R.Max(R.Abs(LongV), R.Abs(LongW)));
        return R.Max(R.Min(-R.Floor(longest * R.Of(-4)), R.Of(CheckerArea.MostPieces)), R.Of(1));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Square(R u, R v, R w) => R.Fma(u, u, R.Fma(v, v, w * w));
}
