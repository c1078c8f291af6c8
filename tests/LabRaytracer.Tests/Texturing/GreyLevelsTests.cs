using LabRaytracer.Tests.Rendering;

namespace LabRaytracer.Tests.Texturing;

/// <summary>Grey levels of pyramids, which "ewa" reads one number a texel.</summary>
public sealed class GreyLevelsTests
{
    private const int Width = 64, Height = 32;

    [Fact]
    public unsafe void Require_GreyPicture_HasTheTexelsOfThePyramidWithItsMargin()
    {
        MipPyramid pyramid = Pyramid(8, (x, y) => Intensity.Grey(((x * 7) + (y * 13)) % 11 / 16f));
        pyramid.Grey.Require(0, pyramid.LevelCount - 1);
        for (int level = 0; level < pyramid.LevelCount; level++)
        {
            Assert.True(pyramid.Grey.Has(level));
            for (int y = -8; y < pyramid.Heights[level] + 8; y++)
            {
                for (int x = -8; x < pyramid.Widths[level] + 8; x++)
                {
                    long texel = pyramid.Starts[level] + ((long)y * pyramid.Strides[level]) + x;
                    Assert.Equal(pyramid.Texels[MipPyramid.Channels * texel], pyramid.Grey.Texels[texel]);
                }
            }
        }
    }

    [Theory]
    [InlineData(0, 0)]
    [InlineData(Width - 1, Height - 1)]
    public void Require_OneTexelOfAnotherColor_IsNotGrey(int columnOfOther, int rowOfOther)
    {
        MipPyramid pyramid = Pyramid(0, (x, y) => x == columnOfOther && y == rowOfOther ? new Intensity(0.5f, 0.5f, 0.25f) : Intensity.Grey(0.5f));
        pyramid.Grey.Require(0, 2);
        Assert.False(pyramid.Grey.Has(0));
        Assert.False(pyramid.Grey.Has(2));
    }

    [Fact]
    public void Require_SomeLevels_AsksForNoOther()
    {
        MipPyramid pyramid = Pyramid(0, (_, _) => Intensity.Grey(0.5f));
        pyramid.Grey.Require(1, 2);
        Assert.Equal([false, true, true, false], Enumerable.Range(0, 4).Select(pyramid.Grey.Has));
    }

    /// <summary>The sums run in another order: a few units of 2^-24 of the largest texel.</summary>
    [Fact]
    public void Sample_GreyPicture_IsThatOfTheSamePictureWithAnotherBlue()
    {
        Texture random = TestScenes.Random(Width, Height);
        TextureSampler Sampler(Func<float, Intensity> color)
        {
            Intensity[,] colors = new Intensity[Width, Height];
            for (int i = 0; i < Width * Height; i++)
            {
                colors[i % Width, i / Width] = color(random.ColorMap[i % Width, i / Width].G);
            }

            return ((IPreparedTexture)new Texture(colors)).Prepare(TextureUse.Color, TextureFilter.Ewa);
        }

        TextureSampler grey = Sampler(Intensity.Grey), colored = Sampler(value => new Intensity(value, value, value / 2));
        for (int k = 0; k < 4000; k++)
        {
            double Turn(double ratio) => (k * ratio) - Math.Floor(k * ratio);
            double longer = 1.5 + (60 * Turn(0.7548776662)), shorter = longer * Turn(0.5698402910), along = Math.Tau * Turn(0.8191725134), across = Math.Tau * Turn(0.6710436067);
            TextureFootprint footprint = new(longer * Math.Cos(along) / Width, longer * Math.Sin(along) / Height, shorter * Math.Cos(across) / Width, shorter * Math.Sin(across) / Height);
            TextureLookup lookup = new(new TextureCoordinate(Turn(0.6180339887), Turn(0.4142135624)), WrapU: TextureWrap.Repeat, WrapV: TextureWrap.Repeat, Footprint: footprint);
            Intensity color = ScalarSampler.Sample(grey, lookup);
            Assert.Equal(ScalarSampler.Sample(colored, lookup).R, color.R, 1e-6);
            Assert.Equal(color.R, color.G);
            Assert.Equal(color.R, color.B);
        }
    }

    [Fact]
    public void Sample_GreyPictureAtEveryWidth_SameBitsAsSingleCall()
    {
        Random random = new(5);
        double Step() => (random.NextDouble() - 0.5) * Math.Pow(2, random.Next(-9, 2));
        TextureLookup[] lookups = [.. Enumerable.Range(0, 400).Select(_ => new TextureLookup(
            new TextureCoordinate(random.NextDouble(), random.NextDouble()), WrapU: TextureWrap.Repeat, WrapV: TextureWrap.Clamp,
            Footprint: new TextureFootprint((float)Step(), (float)Step(), (float)Step(), (float)Step())))];
        Intensity[,] colors = new Intensity[37, 21];
        for (int i = 0; i < 37 * 21; i++)
        {
            colors[i % 37, i / 37] = Intensity.Grey((float)random.NextDouble());
        }

        SamplerRun.SameAsScalar(new Texture(colors).With(SamplingOptions.Default.With(TextureFilter.Ewa)), lookups);
    }

    /// <summary>All levels of a picture.</summary>
    private static unsafe MipPyramid Pyramid(int margin, Func<int, int, Intensity> color)
    {
        float[] samples = new float[4 * Width * Height];
        for (int i = 0; i < Width * Height; i++)
        {
            Intensity texel = color(i % Width, i / Width);
            (samples[4 * i], samples[(4 * i) + 1], samples[(4 * i) + 2], samples[(4 * i) + 3]) = (texel.R, texel.G, texel.B, 1);
        }

        TexelStore store = new(PixelBuffer.FromRgbaFloat(Width, Height, samples, TransferFunction.Linear, "test"));
        MipPyramid pyramid = new(new ReaderRows<FloatReader>(store, null, new FloatReader((float*)store.Samples)), margin);
        pyramid.RequirePicture();
        pyramid.Require(pyramid.LevelCount - 1, 1);
        return pyramid;
    }
}
