using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>What lies outside of a usual axis, compiled into a loop.</summary>
internal interface IAxisWrap
{
    /// <summary>The two texels between which a coordinate lies, and the weight of the second one.</summary>
    /// <param name="coordinate">u or v.</param>
    /// <param name="size">Number of texels.</param>
    /// <param name="first">Number of the texel to the left or below.</param>
    /// <param name="second">Number of the texel to the right or above.</param>
    /// <param name="weight">Weight of the second texel, [0, 1).</param>
    static abstract void Between<R, F, I>(R coordinate, int size, out I first, out I second, out F weight)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>;
}

/// <summary>The axis repeats.</summary>
internal readonly struct RepeatedAxis : IAxisWrap
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Between<R, F, I>(R coordinate, int size, out I first, out I second, out F weight)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R position = R.Fma(Elementary.WrapRepeat(coordinate), R.Of(size), R.Of(-0.5)), floor = R.Floor(position);
        weight = R.ToSingle(position - floor);
        I texel = R.ToInt32(floor), last = I.Of(size - 1), zero = I.Of(0);
        first = I.Select(I.Less(texel, zero), last, I.Min(texel, last));
        second = I.Less(texel, last) & (texel + I.Of(1));
    }
}

/// <summary>The ends of the axis go on.</summary>
internal readonly struct ClampedAxis : IAxisWrap
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Between<R, F, I>(R coordinate, int size, out I first, out I second, out F weight)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R position = R.Fma(Elementary.WrapClamp(coordinate), R.Of(size), R.Of(-0.5)), floor = R.Floor(position);
        weight = R.ToSingle(position - floor);
        I texel = R.ToInt32(floor), last = I.Of(size - 1), zero = I.Of(0);
        first = I.Min(I.Max(texel, zero), last);
        second = I.Min(I.Max(texel + I.Of(1), zero), last);
    }
}
