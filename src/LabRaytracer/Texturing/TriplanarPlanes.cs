using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The three projections of points along the axes, and their weights.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
internal readonly struct TriplanarPlanes<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly R _x, _y, _z;
    private readonly F _normalX, _normalY, _normalZ;
    private readonly double _scale;
    private readonly int _sharpness;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public TriplanarPlanes(TriplanarTexture texture, R x, R y, R z, R normalX, R normalY, R normalZ)
    {
        (_x, _y, _z) = (x, y, z);
        (_normalX, _normalY, _normalZ) = (R.ToSingle(normalX), R.ToSingle(normalY), R.ToSingle(normalZ));
        (_scale, _sharpness) = (texture.Scale / 2, texture.Sharpness);
    }

    /// <summary>Share of one projection, [0, 1].</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public F Weight(int axis)
    {
        F x = Power(F.Abs(_normalX), _sharpness), y = Power(F.Abs(_normalY), _sharpness), z = Power(F.Abs(_normalZ), _sharpness);
        return (axis == 0 ? x : axis == 1 ? y : z) / F.Max(x + y + z, F.Of(1e-30));
    }

    /// <summary>(u, v) of one projection.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (R U, R V) Coordinates(int axis)
    {
        R half = R.Of(0.5), scale = R.Of(_scale), mirrored = R.MaskFromSingle(IsMirrored(axis));
        R right = axis == 0 ? _z : _x, up = axis == 1 ? _z : _y;
        right = axis == 1 ? right : R.Select(mirrored, -right, right);
        up = axis == 1 ? R.Select(mirrored, -up, up) : up;
        return (R.Fma(right, scale, half), R.Fma(up, scale, half));
    }

    /// <summary>A step of (u, v) over a step of the point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (F U, F V) Step(int axis, F x, F y, F z)
    {
        F scale = F.Of(_scale), mirrored = IsMirrored(axis);
        F right = axis == 0 ? z : x, up = axis == 1 ? z : y;
        right = axis == 1 ? right : F.Select(mirrored, -right, right);
        up = axis == 1 ? F.Select(mirrored, -up, up) : up;
        return (right * scale, up * scale);
    }

    /// <summary>Mask: the coordinate across (on top and bottom: up) runs against the axis, so that nobody sees a mirrored picture.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private F IsMirrored(int axis) => axis switch
    {
        0 => F.Less(F.Zero, _normalX),
        1 => F.Less(F.Zero, _normalY),
        _ => F.Less(_normalZ, F.Zero),
    };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Power<T>(T number, int exponent)
        where T : unmanaged, IReal<T>
    {
        T result = T.Of(1);
        for (int left = exponent; left > 0; left >>= 1)
        {
            result = (left & 1) == 0 ? result : result * number;
            number *= number;
        }

        return result;
    }
}
