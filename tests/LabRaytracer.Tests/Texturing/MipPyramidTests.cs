namespace LabRaytracer.Tests.Texturing;

/// <summary>Smaller versions of a picture: exact means, the same whoever makes them.</summary>
public sealed class MipPyramidTests
{
    public static TheoryData<int, int> Sizes => new() { { 1, 1 }, { 2, 2 }, { 64, 32 }, { 37, 21 }, { 100, 75 }, { 1, 13 }, { 17, 1 }, { 255, 3 } };

    [Theory]
    [MemberData(nameof(Sizes))]
    public void Levels_AnySize_KeepTheMean(int width, int height)
    {
        Intensity[,] picture = Random(width, height);
        MipPyramid pyramid = new(new ArrayRows(picture));
        pyramid.Require(pyramid.LevelCount - 1, 1);
        (double red, double green, double blue) = Mean(picture.GetLength(0), picture.GetLength(1), (x, y) => picture[x, y]);
        for (int level = 1; level < pyramid.LevelCount; level++)
        {
            (int w, int h) = Size(pyramid, level);
            (double r, double g, double b) = Mean(w, h, (x, y) => pyramid.Texel(level, x, y));
            Assert.Equal(red, r, 1e-6);
            Assert.Equal(green, g, 1e-6);
            Assert.Equal(blue, b, 1e-6);
        }

        Assert.Equal((1, 1), Size(pyramid, pyramid.LevelCount - 1));
    }

    [Fact]
    public void Levels_SidesArePowersOfTwo_AreMeansOfSquares()
    {
        Intensity[,] picture = Random(32, 16);
        MipPyramid pyramid = new(new ArrayRows(picture));
        pyramid.Require(3, 1);
        double sum = 0;
        for (int x = 8; x < 16; x++)
        {
            for (int y = 0; y < 8; y++)
            {
                sum += picture[x, y].G;
            }
        }

        Assert.Equal(sum / 64, pyramid.Texel(3, 1, 0).G, 1e-6);
    }

    [Fact]
    public void FirstLevel_OddSide_WeighsTexelsByTheirSharedArea()
    {
        // Five texels to two: each covers two and a half.
        Intensity[,] picture = new Intensity[5, 1];
        for (int x = 0; x < 5; x++)
        {
            picture[x, 0] = Intensity.Grey(1 << x);
        }

        MipPyramid pyramid = new(new ArrayRows(picture));
        pyramid.Require(1, 1);
        Assert.Equal((1 + 2 + (4 * 0.5)) / 2.5, pyramid.Texel(1, 0, 0).R, 1e-6);
        Assert.Equal(((4 * 0.5) + 8 + 16) / 2.5, pyramid.Texel(1, 1, 0).R, 1e-6);
    }

    [Fact]
    public void Levels_SeveralThreads_SameBits()
    {
        Intensity[,] picture = Random(301, 211);
        MipPyramid one = new(new ArrayRows(picture)), several = new(new ArrayRows(picture));
        one.Require(one.LevelCount - 1, 1);
        Parallel.For(0, 8, i => several.Require(several.LevelCount - 1 - (i % 3), 3));
        for (int level = 1; level < one.LevelCount; level++)
        {
            (int w, int h) = Size(one, level);
            for (int i = 0; i < w * h; i++)
            {
                Assert.Equal(one.Texel(level, i % w, i / w), several.Texel(level, i % w, i / w));
            }
        }
    }

    [Fact]
    public void Require_LowLevel_BuildsNoHigherOne()
    {
        MipPyramid pyramid = new(new ArrayRows(Random(64, 64)));
        Assert.Equal(0, pyramid.Built);
        pyramid.Require(2, 1);
        Assert.Equal(2, pyramid.Built);
    }

    [Fact]
    public void FirstLevel_SrgbCodes_AreMeansOfLight()
    {
        // Code 0 and 255: half the light, which is code 188, not 128.
        TexelStore store = new(PixelBuffer.FromRgba8(2, 1, [0, 0, 0, 255, 255, 255, 255, 255], TransferFunction.Srgb, "test"));
        TextureSampler sampler = PictureSamplers.Create(store, TextureUse.Color, SamplingOptions.Default, TextureFilter.Trilinear);
        TextureLookup lookup = TextureLookup.At(0.3, 0.5) with { Footprint = new TextureFootprint(1, 0, 0, 1) };
        Assert.Equal(0.5f, ScalarSampler.Sample(sampler, lookup).R, 1e-6f);
    }

    private static unsafe (int Width, int Height) Size(MipPyramid pyramid, int level) => (pyramid.Widths[level], pyramid.Heights[level]);

    private static (double R, double G, double B) Mean(int width, int height, Func<int, int, Intensity> texel)
    {
        (double r, double g, double b) = (0, 0, 0);
        for (int i = 0; i < width * height; i++)
        {
            Intensity color = texel(i % width, i / width);
            (r, g, b) = (r + color.R, g + color.G, b + color.B);
        }

        double share = 1.0 / (width * height);
        return (r * share, g * share, b * share);
    }

    private static Intensity[,] Random(int width, int height)
    {
        Random random = new(width + (1000 * height));
        Intensity[,] picture = new Intensity[width, height];
        for (int i = 0; i < width * height; i++)
        {
            picture[i % width, i / width] = new Intensity(random.NextSingle(), random.NextSingle(), random.NextSingle());
        }

        return picture;
    }

    private sealed unsafe class ArrayRows(Intensity[,] picture) : TexelRows
    {
        public override int Width => picture.GetLength(0);

        public override int Height => picture.GetLength(1);

        public override void Read(int y, float* red, float* green, float* blue)
        {
            for (int x = 0; x < Width; x++)
            {
                (red[x], green[x], blue[x]) = (picture[x, y].R, picture[x, y].G, picture[x, y].B);
            }
        }
    }
}
