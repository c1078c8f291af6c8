using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The weighted mean of 4 x 4 texels.</summary>
/// <typeparam name="TReader">Reads the texels.</typeparam>
/// <param name="Reader">Reads the texels.</param>
/// <param name="Start">Element number of the bottom-left texel.</param>
/// <param name="Stride">Elements of a row; rows go up, element numbers go down.</param>
/// <param name="IsBounded">Whether a mean outside the range of its texels is set to the end of that range.</param>
internal readonly record struct BicubicKernel<TReader>(TReader Reader, int Start, int Stride, bool IsBounded)
    where TReader : struct, ITexelReader
{
    /// <summary>Tells whether a filter's means are kept inside the range of their texels: colours below black must not come of a picture, numbers may overshoot.</summary>
    public static bool Bounds(TextureFilter filter, bool isData) => filter == TextureFilter.CatmullRom && !isData;

    /// <summary>The mean of the texels in four columns and four rows.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Mean<F, I>(in CubicTaps<F, I> columns, in CubicTaps<F, I> rows, out CubicColor<F> mean)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        CubicRange<F> range = CubicRange<F>.Empty;
        Row(columns, rows.Texel0, ref range, out CubicColor<F> row0);
        Row(columns, rows.Texel1, ref range, out CubicColor<F> row1);
        Row(columns, rows.Texel2, ref range, out CubicColor<F> row2);
        Row(columns, rows.Texel3, ref range, out CubicColor<F> row3);
        mean.R = rows.Mean(row0.R, row1.R, row2.R, row3.R);
        mean.G = rows.Mean(row0.G, row1.G, row2.G, row3.G);
        mean.B = rows.Mean(row0.B, row1.B, row2.B, row3.B);
        if (IsBounded)
        {
            range.Clamp(ref mean);
        }
    }

    /// <summary>The mean along one row; compiled on its own, which keeps both methods below what the compiler inlines.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Row<F, I>(in CubicTaps<F, I> columns, I y, ref CubicRange<F> range, out CubicColor<F> mean)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I row = I.Of(Start) - (y * I.Of(Stride));
        Read(row + columns.Texel0, out CubicColor<F> color0);
        Read(row + columns.Texel1, out CubicColor<F> color1);
        Read(row + columns.Texel2, out CubicColor<F> color2);
        Read(row + columns.Texel3, out CubicColor<F> color3);
        mean.R = columns.Mean(color0.R, color1.R, color2.R, color3.R);
        mean.G = columns.Mean(color0.G, color1.G, color2.G, color3.G);
        mean.B = columns.Mean(color0.B, color1.B, color2.B, color3.B);
        if (IsBounded)
        {
            range.Add(color0);
            range.Add(color1);
            range.Add(color2);
            range.Add(color3);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Read<F, I>(I texel, out CubicColor<F> color)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => Reader.Read<F, I>(texel, out color.R, out color.G, out color.B);
}
