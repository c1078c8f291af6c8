using System.Numerics;

namespace LabRaytracer.Validation;

/// <summary>From texture coordinates to texels and colours: wraps, texel choice, the bilinear filter and uv transforms.</summary>
internal sealed class TexelSweep(StressOptions options)
{
    private const int PerPart = 20_000;

    private static readonly TextureWrap[] s_wraps = Enum.GetValues<TextureWrap>();
    private static readonly TexelConvention[] s_conventions = Enum.GetValues<TexelConvention>();

    /// <summary>All lines of the table.</summary>
    public IEnumerable<StressRow> Run() =>
        [Texels<Double8, Float8, Int8>(1e-9), Texels<Float8, Float8, Int8>(1e-2), .. Filters(), Transforms()];

    /// <param name="margin">Nearer than this to the edge between two texels, either may be chosen.</param>
    private StressRow Texels<R, F, I>(double margin)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        string format = R.IsSingle ? "float" : "double";
        Worst worst = new(FormattableString.Invariant($"texel choice, all wraps, margin {margin:0e+0} texel, {format}"), 0, "");
        Parallel.For(0, options.Parts(500), part =>
        {
            Draws draws = Draws.Of(options.Seed, "texel" + format, part);
            for (int i = 0; i < PerPart; i++)
            {
                TexelAxis axis = new(Size(draws), s_wraps[i % s_wraps.Length], s_conventions[i / 4 % s_conventions.Length]);
                double u = Coordinate(draws, axis.Size);
                u = R.IsSingle ? (float)u : u;
                R outside = axis.Nearest<R, F, I>(R.Of(u), out I texel);
                Real position = Exact(axis, u, out bool isOutside);
                BigInteger expected = Real.Floor(position);
                double rest = (position - Real.FromFixed(expected, 0)).ToDouble(), allowed = R.IsSingle ? margin * Math.Max(1, Math.Abs(u)) : margin;
                int found = I.Get(texel, 0);
                bool isSure = rest > allowed && rest < 1 - allowed;
                bool isRight = found >= 0 && found < axis.Size && R.Any(outside) == isOutside && (!isSure || found == BigInteger.Min(expected, axis.Size - 1));
                worst.Count(isRight, $"{axis} at {u:R}: {found}, exactly {position}");
            }
        });
        return worst.ToRow();
    }

    /// <remarks>
    /// A cubic weight is wrong by 4 roundings, a mean of four values adds 4, the second axis carries on what the first one lost times 5/4, and the place between two
    /// texels is rounded to a float, where the mean changes by at most 3/2 a texel: 24 units in all.
    /// </remarks>
    private IEnumerable<StressRow> Filters() =>
    [
        Filter("bilinear filter", TextureFilter.Bilinear, 6),
        Filter("Catmull-Rom filter", TextureFilter.CatmullRom, 24),
        Filter("B-spline filter", TextureFilter.BSpline, 24),
    ];

    private StressRow Filter(string name, TextureFilter filter, double bound)
    {
        Worst worst = new($"{name}, default lanes", bound, "units of 2^-24 of the largest texel");
        Parallel.For(0, options.Parts(100), part =>
        {
            Draws draws = Draws.Of(options.Seed, filter == TextureFilter.Bilinear ? "bilinear" : name, part);
            for (int i = 0; i < PerPart / 20; i++)
            {
                Texture texture = new(1 + draws.Integer(5), 1 + draws.Integer(5)) { Sampling = new SamplingOptions { Filter = filter } };
                foreach (ref Intensity texel in System.Runtime.InteropServices.MemoryMarshal.CreateSpan(ref texture.ColorMap[0, 0], texture.ColorMap.Length))
                {
                    texel = Intensity.Grey((float)draws.Number());
                }

                for (int k = 0; k < 20; k++)
                {
                    double u = Coordinate(draws, texture.Width), v = Coordinate(draws, texture.Height);
                    double found = texture.Sample(TextureLookup.At(u, v) with { WrapU = TextureWrap.Clamp, WrapV = TextureWrap.Clamp }).R;
                    if (ExactFilter.Of(filter, texture, u, v) is { } exact)
                    {
                        worst.Note(Math.Abs((found - exact).ToDouble()) * (1 << 24), $"{texture.Width} x {texture.Height} at ({u:R}, {v:R})");
                    }
                }
            }
        });
        return worst.ToRow();
    }

    private StressRow Transforms()
    {
        Worst worst = new("uv transform, quarter turns", 4, "eps of the terms");
        Parallel.For(0, options.Parts(100), part =>
        {
            Draws draws = Draws.Of(options.Seed, "transforms", part);
            TextureCoordinate Pair(double reach) => new(draws.Number(-reach, reach), draws.Number(-reach, reach));
            for (int i = 0; i < PerPart / 4; i++)
            {
                TextureCoordinate offset = Pair(2), scale = Pair(8), center = Pair(1), at = Pair(3);
                int turn = draws.Integer(4);
                TextureCoordinate found = new UvTransform(offset, 90 * turn, scale, center).Apply(at);
                Real x = (at.U - (Real)center.U) * scale.U, y = (at.V - (Real)center.V) * scale.V;
                (Real u, Real v) = turn switch { 0 => (x, y), 1 => (-y, x), 2 => (-x, -y), _ => (y, -x) };
                double terms = Math.Abs(offset.U) + Math.Abs(offset.V) + 2 + ((3 + 1) * (Math.Abs(scale.U) + Math.Abs(scale.V)));
                double error = Math.Max(Math.Abs((found.U - (u + center.U + offset.U)).ToDouble()), Math.Abs((found.V - (v + center.V + offset.V)).ToDouble()));
                worst.Note(error / terms * Math.ScaleB(1, 53), $"offset {offset}, turn {turn}, scale {scale}, centre {center}, at {at}");
            }
        });
        return worst.ToRow();
    }

    private static int Size(Draws draws) => draws.Integer(4) switch { 0 => 1 + draws.Integer(9), 1 => 8192, 2 => 4096, _ => 1 + draws.Integer(100_000) };

    private static double Coordinate(Draws draws, int size) => draws.Integer(6) switch
    {
        0 => draws.Number(),
        1 => draws.Number(-5, 5),
        2 => (double)draws.Integer(size + 1) / size,
        3 => ((double)draws.Integer(size + 1) / size) + (draws.Sign() * draws.Scale(-18, -5)),
        4 => draws.Integer(5) - 2 + (draws.Sign() * draws.Scale(-20, -1)),
        _ => (draws.Integer(size) + 0.5) / size,
    };

    /// <summary>Where a coordinate falls on an axis, in texels from the edge of the first one.</summary>
    private static Real Exact(in TexelAxis axis, double coordinate, out bool isOutside)
    {
        Real u = coordinate, whole = Real.FromFixed(Real.Floor(u), 0);
        isOutside = axis.Wrap == TextureWrap.Border && (coordinate < 0 || coordinate > 1);
        Real inside = axis.Wrap switch
        {
            TextureWrap.Repeat => u - whole,
            TextureWrap.Mirror => Real.Floor(u).IsEven ? u - whole : 1 - (u - whole),
            _ => u < 0 ? 0 : u > 1 ? 1 : u,
        };
        return inside * (axis.Texels == TexelConvention.Lab ? axis.Size - 1 : axis.Size);
    }
}
