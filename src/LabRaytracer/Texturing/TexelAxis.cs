using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>One axis of a picture: which texels a coordinate falls on.</summary>
/// <param name="Size">Number of texels along the axis, at least 1.</param>
/// <param name="Wrap">What lies outside.</param>
/// <param name="Texels">Where texels lie.</param>
internal readonly record struct TexelAxis(int Size, TextureWrap Wrap, TexelConvention Texels)
{
    /// <summary>The texel that a coordinate falls on.</summary>
    /// <param name="coordinate">u or v.</param>
    /// <param name="texel">Its number, [0, size).</param>
    /// <returns>Mask of lanes outside the picture (border only).</returns>
    /// <remarks>Compiled on its own: together with the texel reads it would exceed what the compiler inlines, and every lane operation would be a call.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public R Nearest<R, F, I>(R coordinate, out I texel)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R inside = Wrapped(coordinate);
        R position = Texels == TexelConvention.Lab ? inside * R.Of(Size - 1) : R.Floor(inside * R.Of(Size));
        texel = I.Max(I.Min(R.ToInt32(position), I.Of(Size - 1)), I.Of(0));
        return Outside(coordinate);
    }

    /// <summary>The two texels between which a coordinate lies, and the weight of the second one.</summary>
    /// <param name="coordinate">u or v.</param>
    /// <param name="first">Number of the texel to the left or below.</param>
    /// <param name="second">Number of the texel to the right or above.</param>
    /// <param name="weight">Weight of the second texel, [0, 1).</param>
    /// <returns>Mask of lanes outside the picture (border only).</returns>
    /// <remarks>Compiled on its own: together with the texel reads it would exceed what the compiler inlines, and every lane operation would be a call.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public R Between<R, F, I>(R coordinate, out I first, out I second, out F weight)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R inside = Wrapped(coordinate);
        R position = Texels == TexelConvention.Lab ? inside * R.Of(Size - 1) : R.Fma(inside, R.Of(Size), R.Of(-0.5));
        R floor = R.Floor(position);
        weight = R.ToSingle(position - floor);
        I texel = R.ToInt32(floor);
        I last = I.Of(Size - 1), zero = I.Of(0), one = I.Of(1);
        if (Wrap == TextureWrap.Repeat && Texels == TexelConvention.Center)
        {
            first = I.Select(I.Less(texel, zero), last, I.Min(texel, last));
            second = I.Select(I.Less(texel, last), texel + one, zero);
        }
        else
        {
            first = I.Min(I.Max(texel, zero), last);
            second = I.Min(I.Max(texel + one, zero), last);
        }

        return Outside(coordinate);
    }

    /// <summary>The coordinate brought into [0, 1].</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private R Wrapped<R>(R coordinate)
        where R : unmanaged, IReal<R> => Wrap switch
        {
            TextureWrap.Repeat => Elementary.WrapRepeat(coordinate),
            TextureWrap.Mirror => Elementary.WrapMirror(coordinate),
            _ => Elementary.WrapClamp(coordinate),
        };

    /// <summary>Mask of coordinates outside a picture with a border.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private R Outside<R>(R coordinate)
        where R : unmanaged, IReal<R> => Wrap == TextureWrap.Border
            ? R.Less(coordinate, R.Zero) | R.Less(R.Of(1), coordinate)
            : R.Zero;
}
