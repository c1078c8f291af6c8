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
    public R Nearest<R, F, I>(in R coordinate, out I texel)
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
    public R Between<R, F, I>(in R coordinate, out I first, out I second, out F weight)
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

    /// <summary>The four texels around a coordinate and their weights.</summary>
    /// <param name="coordinate">u or v.</param>
    /// <param name="filter">Catmull-Rom or B-spline.</param>
    /// <param name="taps">Texels and weights.</param>
    /// <returns>Mask of lanes outside the picture (border only).</returns>
    /// <remarks>Texels beyond an end are those that the wrap puts there; with a border, those at the end.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public R Around<R, F, I>(R coordinate, TextureFilter filter, out CubicTaps<F, I> taps)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R inside = Wrapped(coordinate);
        R position = Texels == TexelConvention.Lab ? inside * R.Of(Size - 1) : R.Fma(inside, R.Of(Size), R.Of(-0.5));
        R floor = R.Floor(position);
        I texel = R.ToInt32(floor), one = I.Of(1);
        taps = default;
        taps.Weigh(filter, R.ToSingle(position - floor));
        taps.Texel0 = Inside(texel - one);
        taps.Texel1 = Inside(texel);
        taps.Texel2 = Inside(texel + one);
        taps.Texel3 = Inside(texel + I.Of(2));
        return Outside(coordinate);
    }

    /// <summary>The texel that stands at a place up to two beyond an end of the picture.</summary>
    private I Inside<I>(I texel)
        where I : unmanaged, IIndexLane<I>
    {
        I zero = I.Of(0), size = I.Of(Size), last = I.Of(Size - 1);
        if (Wrap == TextureWrap.Repeat && Texels == TexelConvention.Center)
        {
            // Twice: a picture may have a single texel.
            for (int turn = 0; turn < 2; turn++)
            {
                texel = I.Select(I.Less(texel, zero), texel + size, I.Select(I.Less(last, texel), texel - size, texel));
            }
        }
        else if (Wrap == TextureWrap.Mirror)
        {
            // Texels mirror at the edge of the last one; the sheet's nodes at the last node itself.
            int edge = Texels == TexelConvention.Center ? 1 : 0;
            texel = I.Select(I.Less(texel, zero), I.Of(-edge) - texel, texel);
            texel = I.Select(I.Less(last, texel), last + last + I.Of(edge) - texel, texel);
        }

        return I.Min(I.Max(texel, zero), last);
    }

    /// <summary>The coordinate brought into [0, 1].</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal R Wrapped<R>(R coordinate)
        where R : unmanaged, IReal<R> => Wrap switch
        {
            TextureWrap.Repeat => Elementary.WrapRepeat(coordinate),
            TextureWrap.Mirror => Elementary.WrapMirror(coordinate),
            _ => Elementary.WrapClamp(coordinate),
        };

    /// <summary>Mask of coordinates outside a picture with a border.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal R Outside<R>(R coordinate)
        where R : unmanaged, IReal<R> => Wrap == TextureWrap.Border
            ? R.Less(coordinate, R.Zero) | R.Less(R.Of(1), coordinate)
            : R.Zero;
}
