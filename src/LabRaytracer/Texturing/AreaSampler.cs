namespace LabRaytracer;

/// <summary>The exact mean of the bilinear picture over the parallelogram of the footprint.</summary>
/// <typeparam name="TReader">Reads the store's format.</typeparam>
/// <remarks>
/// The parallelogram is cut along the lines between texel centres; inside each cell the picture is a polynomial, whose integral over the polygon is known in closed form.
/// In doubles, one sample after the other. Footprints that touch more than <see cref="MostCells"/> cells are integrated over the first level of the pyramid on which they
/// do not, whose texels are exact means themselves; those that are larger still, or no numbers, see the mean of the whole picture.
/// </remarks>
internal sealed unsafe class AreaSampler<TReader>(
    TexelStore store, float[]? table, TReader reader, SamplingOptions options, MipPyramid pyramid) : MipSampler<TReader>(store, table, reader, options, pyramid)
    where TReader : struct, ITexelReader
{
    /// <summary>Most cells that one sample reads.</summary>
    public const int MostCells = 1 << 20;

    protected override void Filter<R, F, I>(in LookupBatch<R> lookups, in TexelAxis across, in TexelAxis up, in ColorColumns<F> colors, int packets)
    {
        R* places = stackalloc R[2];
        for (int packet = 0; packet < packets; packet++)
        {
            R u = lookups.Coordinates.U[packet], v = lookups.Coordinates.V[packet];
            places[0] = Place(across, u);
            places[1] = Place(up, v);
            uint outside = R.Bits(across.Outside(u) | up.Outside(v));
            for (int lane = 0; lane < R.Width && (packet * R.Width) + lane < lookups.Count; lane++)
            {
                int i = (packet * R.Width) + lane;
                bool isInside = (outside >> lane & 1) == 0;
                colors.Put(i, isInside ? Mean(lookups.Footprints.Take(i), across, up, R.Take(places, lane), R.Take(places + 1, lane)) : Intensity.Black);
            }
        }
    }

    private Intensity Mean(in TextureFootprint footprint, in TexelAxis across, in TexelAxis up, double u, double v)
    {
        int level = 0;
        while (level < Pyramid.LevelCount - 1 && !((footprint.ExtentU * Pyramid.Widths[level] + 2) * (footprint.ExtentV * Pyramid.Heights[level] + 2) <= MostCells))
        {
            level++;
        }

        Pyramid.Require(level, Threads);
        int width = Pyramid.Widths[level], height = Pyramid.Heights[level];
        if (width == 1 && height == 1)
        {
            return Texel(level, 0, 0, across.Wrap, up.Wrap);
        }

        FootprintArea area = new((u * width) - 0.5, (v * height) - 0.5, footprint, width, height);
        return area.Mean(new Texels(this, level, across.Wrap, up.Wrap));
    }

    private Intensity Texel(int level, int x, int y, TextureWrap wrapU, TextureWrap wrapV)
    {
        int width = Pyramid.Widths[level], height = Pyramid.Heights[level];
        int turn = wrapV == TextureWrap.Pole && (uint)y >= (uint)height ? width / 2 : 0;
        x = EwaLevel.Wrap(x + turn, width, wrapU);
        y = EwaLevel.Wrap(y, height, wrapV);
        if (level > 0)
        {
            return Pyramid.Texel(level, x, y);
        }

        Reader.Read(new Int1(Start - (y * width) + x), out Float1 red, out Float1 green, out Float1 blue);
        return new Intensity(red.Value, green.Value, blue.Value);
    }

    /// <summary>The texels of a level.</summary>
    private readonly struct Texels(AreaSampler<TReader> sampler, int level, TextureWrap wrapU, TextureWrap wrapV) : IAreaTexels
    {
        public int Period => wrapU switch
        {
            TextureWrap.Repeat => sampler.Pyramid.Widths[level],
            TextureWrap.Mirror => 2 * sampler.Pyramid.Widths[level],
            _ => int.MaxValue,
        };

        public Intensity At(int column, int row) => sampler.Texel(level, column, row, wrapU, wrapV);
    }
}
