using LabRaytracer.Tests.Rendering;

namespace LabRaytracer.Tests.Texturing;

/// <summary>Trilinear, elliptical and exact averages over the footprints of samples.</summary>
public sealed class FilterTests
{
    private const TextureFilter Trilinear = TextureFilter.Trilinear, Ewa = TextureFilter.Ewa, Area = TextureFilter.Area;

    public static TheoryData<TextureFilter, TextureWrap, TextureWrap> Ways => new()
    {
        { Trilinear, TextureWrap.Repeat, TextureWrap.Pole },
        { Trilinear, TextureWrap.Clamp, TextureWrap.Mirror },
        { Trilinear, TextureWrap.Mirror, TextureWrap.Repeat },
        { Trilinear, TextureWrap.Border, TextureWrap.Clamp },
        { Ewa, TextureWrap.Repeat, TextureWrap.Pole },
        { Ewa, TextureWrap.Clamp, TextureWrap.Mirror },
        { Ewa, TextureWrap.Mirror, TextureWrap.Repeat },
        { Ewa, TextureWrap.Border, TextureWrap.Clamp },
    };

    /// <summary>Beyond a border there is nothing, also where a sample covers many texels: what was looked up there before, for another material, does not shine through.</summary>
    [Theory]
    [InlineData(TextureFilter.Trilinear)]
    [InlineData(TextureFilter.Ewa)]
    [InlineData(TextureFilter.Area)]
    public void Border_WideFootprintsOutside_AreBlack(TextureFilter filter)
    {
        var colors = new Intensity[64, 64];
        System.Runtime.InteropServices.MemoryMarshal.CreateSpan(ref colors[0, 0], colors.Length).Fill(Intensity.White);
        TextureSlot Slot(TextureWrap wrap, UvTransform transform) => new()
        {
            Value = Intensity.White, Texture = new Texture(colors).With(new SamplingOptions { Filter = filter, WrapU = wrap, WrapV = wrap }), Transform = transform,
        };
        var scene = new Scene { Camera = TestScenes.AboveQuad() };
        scene.Add(new Quad(), TestScenes.Shining(Slot(TextureWrap.Repeat, UvTransform.Identity)), Transform.Scaling(new Vector3D(1, 1, 0.5)).Then(Transform.Translation(new Vector3D(0, 0, -0.5))));
        UvTransform away = new(new TextureCoordinate(3, 0), 0, new TextureCoordinate(1, 1), default);
        scene.Add(new Quad(), TestScenes.Shining(Slot(TextureWrap.Border, away)), Transform.Scaling(new Vector3D(1, 1, 0.5)).Then(Transform.Translation(new Vector3D(0, 0, 0.5))));
        Picture picture = TestScenes.Render(scene, 20, 20);
        for (int x = 0; x < 20; x++)
        {
            Assert.Equal(Intensity.Grey(x < 10 ? 1 : 0), picture[x, 7]);
        }
    }

    [Theory]
    [MemberData(nameof(Ways))]
    public void Sample_EveryWidth_SameBitsAsSingleCall(TextureFilter filter, TextureWrap wrapU, TextureWrap wrapV)
    {
        Random random = new(5);
        double Step() => (random.NextDouble() - 0.5) * Math.Pow(2, random.Next(-9, 2));
        TextureLookup[] lookups = [.. Enumerable.Range(0, 400).Select(_ => new TextureLookup(
            new TextureCoordinate((3 * random.NextDouble()) - 1, (3 * random.NextDouble()) - 1), WrapU: wrapU, WrapV: wrapV,
            Footprint: new TextureFootprint((float)Step(), (float)Step(), (float)Step(), (float)Step())))];
        SamplerRun.SameAsScalar(Of(TestScenes.Random(37, 21), filter), lookups);
    }

    [Theory]
    [InlineData(0.9)]
    [InlineData(1)]
    [InlineData(1.5)]
    [InlineData(2)]
    [InlineData(5.7)]
    [InlineData(16)]
    [InlineData(100)]
    public void Trilinear_LevelsOfKnownColors_ShowsTheLogarithmOfTheLongerSide(double texels)
    {
        Intensity color = Levels(Trilinear).Sample(texels / 128, 0, 0, 0.5 / 128);
        Assert.Equal(Math.Max(0, Math.Log2(texels)), color.R, 2e-3);
    }

    [Theory]
    [InlineData(4, 4, 1)]
    [InlineData(15, 3.9, 0)]
    [InlineData(15, 4.1, 1)]
    [InlineData(40, 3.9, 1)]
    [InlineData(40, 8.1, 2)]
    [InlineData(2.5, 40, 1)]
    [InlineData(128, 1, 1)]
    [InlineData(128, 128, 6)]
    public void Ewa_LevelsOfKnownColors_ShowsTheLogarithmOfHalfTheShorterSideUpToThatOfTheShorterSide(double texelsU, double texelsV, int level)
    {
        Intensity color = Levels(Ewa).Sample(texelsU / 128, 0, 0, texelsV / 128);
        Assert.Equal(level, color.R, 1e-4);
    }

    [Theory]
    [InlineData(Trilinear)]
    [InlineData(Ewa)]
    public void Sample_SmallFootprint_IsBilinear(TextureFilter filter)
    {
        Texture picture = TestScenes.Random(64, 32), filtered = Of(picture, filter), bilinear = Of(picture, TextureFilter.Bilinear);
        foreach (double u in SamplerRun.Coordinates.Where(c => Math.Abs(c) < 1e6))
        {
            TextureLookup lookup = TextureLookup.At(u, 0.37) with { Footprint = new TextureFootprint(0.9 / 64, 0, 0, 0.9 / 32) };
            Assert.Equal(bilinear.Sample(lookup), filtered.Sample(lookup));
            Assert.Equal(bilinear.Sample(lookup), filtered.Sample(lookup with { Footprint = new TextureFootprint(double.NaN, 0, 0, 0) }));
            Assert.Equal(bilinear.Sample(lookup), filtered.Sample(lookup with { Footprint = default }));
        }
    }

    [Theory]
    [InlineData(Trilinear, 1e-6)]
    [InlineData(Ewa, 1e-6)]
    [InlineData(Area, 1e-6)]
    public void Sample_OneColor_IsThatColor(TextureFilter filter, double tolerance)
    {
        Intensity[,] colors = new Intensity[33, 17];
        for (int i = 0; i < 33 * 17; i++)
        {
            colors[i % 33, i / 33] = new Intensity(0.3f, 0.6f, 0.9f);
        }

        Texture texture = Of(new Texture(colors), filter);
        foreach (TextureWrap wrap in new[] { TextureWrap.Repeat, TextureWrap.Clamp, TextureWrap.Mirror, TextureWrap.Pole })
        {
            for (int k = 0; k < 50; k++)
            {
                Intensity color = texture.Sample(new TextureLookup(
                    new TextureCoordinate((k * 0.13) - 2, (k * 0.07) - 1), WrapU: wrap, WrapV: wrap, Footprint: new TextureFootprint(0.3, 0.01 * k, -0.02 * k, 0.001)));
                Assert.Equal(0.3, color.R, tolerance);
                Assert.Equal(0.9, color.B, tolerance);
            }
        }
    }

    /// <summary>Just below a horizon a pixel covers more of a floor than there are texels to count, and in the end infinitely much.</summary>
    [Theory]
    [InlineData(Trilinear, 1e12, 1e-6)]
    [InlineData(Ewa, 1e12, 1e-3)]
    [InlineData(Area, 1e12, 1e-6)]
    [InlineData(Area, 3e38, 1e-6)]
    [InlineData(Area, double.PositiveInfinity, 1e-6)]
    [InlineData(Area, double.NaN, 1e-6)]
    public void Sample_FootprintAsWideAsTheWorld_IsTheMeanOfThePicture(TextureFilter filter, double size, double tolerance)
    {
        Texture picture = TestScenes.Random(16, 8);
        Intensity color = Of(picture, filter).Sample(new TextureLookup(new TextureCoordinate(0.3, 0.6), Footprint: new TextureFootprint(size, 0, 1, size)));
        Assert.Equal(picture.ColorMap.Cast<Intensity>().Average(texel => texel.R), color.R, tolerance);
        Assert.Equal(picture.ColorMap.Cast<Intensity>().Average(texel => texel.B), color.B, tolerance);
    }

    [Theory]
    [InlineData(Trilinear)]
    [InlineData(Ewa)]
    [InlineData(Area)]
    public void Sample_AcrossTheSeam_IsThatOfAPictureTurned(TextureFilter filter)
    {
        Texture picture = TestScenes.Random(64, 32);
        Intensity[,] turned = new Intensity[64, 32];
        for (int x = 0; x < 64; x++)
        {
            for (int y = 0; y < 32; y++)
            {
                turned[x, y] = picture.ColorMap[(x + 32) % 64, y];
            }
        }

        for (int k = 0; k < 20; k++)
        {
            TextureFootprint footprint = new(0.05 + (0.01 * k), 0.02, 0.01, 0.06);
            Intensity atSeam = Of(picture, filter).Sample(TextureLookup.At((k - 10) / 256.0, 0.5) with { Footprint = footprint });
            Intensity inside = Of(new Texture(turned), filter).Sample(TextureLookup.At(0.5 + ((k - 10) / 256.0), 0.5) with { Footprint = footprint });
            Assert.Equal(inside.G, atSeam.G, 1e-5);
        }
    }

    [Theory]
    [InlineData(Trilinear)]
    [InlineData(Ewa)]
    [InlineData(Area)]
    public void Sample_AtThePole_GoesOnAtTheOtherSide(TextureFilter filter)
    {
        // Exactly at the pole both sides lie at the same distance: half a turn further the colour is the same.
        Texture texture = Of(TestScenes.Random(64, 32), filter);
        foreach (double v in new[] { 0.0, 1.0 })
        {
            TextureLookup here = new(new TextureCoordinate(0.2, v), WrapU: TextureWrap.Repeat, WrapV: TextureWrap.Pole, Footprint: new TextureFootprint(0.04, 0, 0, 0.1));
            Intensity other = texture.Sample(here with { Coordinate = new TextureCoordinate(0.7, v) });
            Assert.Equal(other.R, texture.Sample(here).R, 1e-5);
            Assert.NotEqual(other.R, texture.Sample(here with { WrapV = TextureWrap.Clamp }).R, 1e-3);
        }
    }

    [Theory]
    [InlineData(TextureFilter.Bilinear, 0.2, 1)]
    [InlineData(Trilinear, 0, 0.2)]
    [InlineData(Ewa, 0, 0.05)]
    public void Sample_CheckerToTheHorizon_ErrorAgainstTheIntegral(TextureFilter filter, double least, double most) =>
        Assert.InRange(Error(Checker(), filter, k => new TextureFootprint(0.0003 * (k + 3), 0.00005 * k, -0.0001 * (k + 3), 0.000004 * (k + 8) * (k + 8))), least, most);

    [Theory]
    [InlineData(TextureFilter.Bilinear, 0.06, 1)]
    [InlineData(Trilinear, 0, 0.05)]
    [InlineData(Ewa, 0, 0.035)]
    public void Sample_NoiseFromAfar_ErrorAgainstTheIntegral(TextureFilter filter, double least, double most) =>
        Assert.InRange(Error(TestScenes.Random(128, 64), filter, k => new TextureFootprint(0.001 * (k + 8), 0, 0, 0.002 * (k + 8))), least, most);

    private static double Error(Texture picture, TextureFilter filter, Func<int, TextureFootprint> footprint)
    {
        TextureSampler filtered = Sampler(picture, filter), exact = Sampler(picture, Area);
        double sum = 0;
        const int Count = 600;
        for (int k = 0; k < Count; k++)
        {
            TextureLookup lookup = TextureLookup.At(k * 0.6180339887 % 1, k * 0.7548776662 % 1) with { Footprint = footprint(k / 6) };
            double error = ScalarSampler.Sample(filtered, lookup).G - ScalarSampler.Sample(exact, lookup).G;
            sum += error * error;
        }

        return Math.Sqrt(sum / Count);
    }

    private static Texture Checker()
    {
        Intensity[,] colors = new Intensity[256, 256];
        for (int i = 0; i < 256 * 256; i++)
        {
            colors[i % 256, i / 256] = Intensity.Grey(((i % 256 / 8) + (i / 256 / 8)) % 2);
        }

        return new Texture(colors);
    }

    private static Texture Of(Texture texture, TextureFilter filter) => texture.With(SamplingOptions.Default.With(filter));

    private static TextureSampler Sampler(Texture texture, TextureFilter filter) => ((IPreparedTexture)texture).Prepare(TextureUse.Color, filter);

    private static KnownLevels Levels(TextureFilter filter) => new(filter);

    /// <summary>A picture of 128 x 128 texels whose levels have their own number for a colour.</summary>
    private sealed unsafe class KnownLevels
    {
        private readonly TextureSampler _sampler;

        public KnownLevels(TextureFilter filter)
        {
            TexelStore store = new(PixelBuffer.FromRgbaFloat(128, 128, new float[4 * 128 * 128], TransferFunction.Linear, "test"));
            FloatReader reader = new((float*)store.Samples);
            MipPyramid pyramid = new(new ReaderRows<FloatReader>(store, null, reader));
            pyramid.Require(pyramid.LevelCount - 1, 1);
            for (int level = 1; level < pyramid.LevelCount; level++)
            {
                float* texels = pyramid.Texels + (MipPyramid.Channels * pyramid.Starts[level]);
                for (int i = 0; i < MipPyramid.Channels * pyramid.Strides[level] * pyramid.Heights[level]; i++)
                {
                    texels[i] = i % MipPyramid.Channels == 3 ? 1 : level;
                }
            }

            _sampler = filter == Ewa
                ? new EwaSampler<FloatReader>(store, null, reader, SamplingOptions.Default, pyramid)
                : new TrilinearSampler<FloatReader>(store, null, reader, SamplingOptions.Default, pyramid);
        }

        public Intensity Sample(double dudx, double dvdx, double dudy, double dvdy) =>
            ScalarSampler.Sample(_sampler, TextureLookup.At(0.4, 0.6) with { Footprint = new TextureFootprint(dudx, dvdx, dudy, dvdy) });
    }
}
