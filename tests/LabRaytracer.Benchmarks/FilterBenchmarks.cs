using System.Globalization;
using BenchmarkDotNet.Attributes;
using LabRaytracer.Validation;

namespace LabRaytracer.Benchmarks;

/// <summary>
/// 4096 lookups of a busy picture of 512 x 256 texels, one thread, time per lookup, by filter and by the size of the footprint. The column RMSE is the distance
/// from the exact mean of the interpolated picture over the footprint: what a pixel ought to show.
/// </summary>
[Config(typeof(ErrorConfig<FilterBenchmarks>))]
public unsafe class FilterBenchmarks : IMeasuresErrors
{
    private const int Count = 4096, PictureWidth = 512, PictureHeight = 256;
    private readonly LaneMemory _memory = new();
    private readonly TextureLookup[] _lookups = new TextureLookup[Count];
    private readonly Texture _texture = new(PictureWidth, PictureHeight);
    private LookupBatch<Double16> _batch;
    private ColorColumns<Float16> _colors;
    private TextureSampler _sampler = null!;

    /// <summary>The filter.</summary>
    [Params(TextureFilter.Nearest, TextureFilter.Bilinear, TextureFilter.CatmullRom, TextureFilter.BSpline, TextureFilter.Trilinear, TextureFilter.Ewa)]
    public TextureFilter Filter { get; set; }

    /// <summary>Length of the footprint, texels; it is four times longer than wide, and turned at random.</summary>
    [Params(0.5, 8.0)]
    public double Texels { get; set; } = 8;

    /// <inheritdoc/>
    public static IReadOnlyList<string> ErrorNames => ["RMSE"];

    [GlobalSetup]
    public void Setup()
    {
        Draws draws = Draws.Of(2009, "filter", 0);
        foreach (ref Intensity texel in System.Runtime.InteropServices.MemoryMarshal.CreateSpan(ref _texture.ColorMap[0, 0], PictureWidth * PictureHeight))
        {
            texel = new Intensity((float)draws.Number(), (float)draws.Number(), draws.Integer(2));
        }

        _batch = new LookupBatch<Double16>
        {
            Coordinates = new CoordinateBatch<Double16> { U = _memory.Column<Double16>(Count, 16), V = _memory.Column<Double16>(Count, 16) },
            Footprints = new FootprintColumns(_memory, Count),
            WrapU = TextureWrap.Repeat, WrapV = TextureWrap.Repeat, Count = Count,
        };
        _colors = new ColorColumns<Float16>(_memory, Count);
        for (int i = 0; i < Count; i++)
        {
            double angle = draws.Number(0, Math.Tau), cos = Math.Cos(angle), sin = Math.Sin(angle);
            TextureFootprint footprint = new(
                (float)(Texels * cos / PictureWidth), (float)(Texels * sin / PictureHeight), (float)(Texels / -4 * sin / PictureWidth), (float)(Texels / 4 * cos / PictureHeight));
            _lookups[i] = TextureLookup.At(draws.Number(), draws.Number()) with { Footprint = footprint };
            Lane.Put(_batch.Coordinates.U, i, _lookups[i].Coordinate.U);
            Lane.Put(_batch.Coordinates.V, i, _lookups[i].Coordinate.V);
            _batch.Footprints.Put(i, footprint);
        }

        _sampler = ((IPreparedTexture)_texture).Prepare(TextureUse.Color, Filter);
    }

    [Benchmark(OperationsPerInvoke = Count)]
    public void DoubleLanes() => _sampler.Sample<Double16, Float16, Int16>(_batch, _colors, Count / 16);

    /// <inheritdoc/>
    public IReadOnlyList<string> Errors(string method)
    {
        DoubleLanes();
        _texture.Sampling = _texture.Sampling.With(TextureFilter.Area);
        double sum = 0;
        for (int i = 0; i < Count; i++)
        {
            Intensity difference = _colors.Take(i) - _texture.Sample(_lookups[i]);
            sum += (difference.R * difference.R) + (difference.G * difference.G) + (difference.B * difference.B);
        }

        return [Math.Sqrt(sum / (3 * Count)).ToString("F4", CultureInfo.InvariantCulture)];
    }
}
