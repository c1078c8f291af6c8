using LabRaytracer.Tests.Rendering;

namespace LabRaytracer.Tests.Texturing;

/// <summary>The weights of the filter "ewa": shares of texels inside the parallelogram of the footprint.</summary>
public sealed class EwaTests
{
    private const int Width = 64, Height = 32;

    private static readonly Texture s_picture = TestScenes.Random(Width, Height);

    private static readonly Texture s_filtered = s_picture.With(SamplingOptions.Default.With(TextureFilter.Ewa));

    // Sides in texels; at least one of them from 1 to 2, so that level 0 is read, and the other one above 2, where nothing of the bilinear colour is left.
    [Theory]
    [InlineData(1, 3)]
    [InlineData(1.7, 5.3)]
    [InlineData(11.25, 1.25)]
    [InlineData(1.99, 30)]
    [InlineData(2.5, 1.5)]
    public void Sample_BoxAlongTheAxes_IsTheMeanOfTheTexelsByTheirShares(double sideU, double sideV)
    {
        for (int k = 0; k < 40; k++)
        {
            // Exact as floats.
            (double x, double y) = (5 + (k * 1.328125), 3 + (k * 0.6875));
            double expected = 0;
            for (int i = -40; i < 120; i++)
            {
                for (int j = -40; j < 90; j++)
                {
                    expected += Share(i, x, sideU) * Share(j, y, sideV) * Texel(i, j);
                }
            }

            Assert.Equal(expected / (sideU * sideV), Sample(x, y, sideU, 0, 0, sideV), 1e-5);
            Assert.Equal(expected / (sideU * sideV), Sample(x, y, 0, sideV, -sideU, 0), 1e-5);
        }
    }

    [Theory]
    [InlineData(0)]
    [InlineData(0.01)]
    [InlineData(0.6)]
    public void Sample_NarrowerThanATexel_IsLinearAcross(double narrow)
    {
        // Rows all alike: whatever is averaged along v, across it remains linear interpolation.
        Intensity[,] columns = new Intensity[Width, Height];
        for (int i = 0; i < Width * Height; i++)
        {
            columns[i % Width, i / Width] = s_picture.ColorMap[i % Width, 0];
        }

        Texture filtered = new Texture(columns).With(SamplingOptions.Default.With(TextureFilter.Ewa));
        for (double x = 3.1; x < 50; x += 1.7)
        {
            int left = (int)Math.Floor(x - 0.5);
            double share = x - 0.5 - left, expected = ((1 - share) * columns[left, 0].G) + (share * columns[left + 1, 0].G);
            Assert.Equal(expected, Sample(filtered, x, 15.3, narrow, 0, 0, 7), 1e-5);
        }
    }

    // Bounds: a weight that is wrong by a twentieth of its share for texels at the edge, of noise with a deviation of 0.29.
    [Theory]
    [InlineData(1.5, 0.4, -0.9, 4)]
    [InlineData(5, 5.5, -1.1, 1)]
    [InlineData(3, 1.2, 2.5, -0.7)]
    [InlineData(6, 0.8, 6, -0.8)]
    [InlineData(9, 9.5, 6, 8)]
    public void Sample_AnyParallelogram_IsNearTheMeanOverIt(double ax, double ay, double bx, double by)
    {
        double squares = 0;
        const int Count = 40, Side = 60;
        for (int k = 0; k < Count; k++)
        {
            (double x, double y) = (17 + (k * 0.7265625), 15.5 + (k * 0.078125));
            double sum = 0;
            for (int i = 0; i < Side * Side; i++)
            {
                double s = (((i % Side) + 0.5) / Side) - 0.5, t = (((i / Side) + 0.5) / Side) - 0.5;
                sum += Texel((int)Math.Floor(x + (s * ax) + (t * bx)), (int)Math.Floor(y + (s * ay) + (t * by)));
            }

            double error = Sample(x, y, ax, ay, bx, by) - (sum / (Side * Side));
            squares += error * error;
        }

        Assert.InRange(Math.Sqrt(squares / Count), 0, 0.015);
    }

    [Fact]
    public void Sample_OnPictureThatStaysPacked_IsTheSame()
    {
        // More texels than are unpacked: the blocks are read from the store.
        Intensity[,] colors = new Intensity[2048, 1024];
        for (int i = 0; i < 2048 * 1024; i++)
        {
            colors[i % 2048, i / 2048] = s_picture.ColorMap[i % Width, i / 2048 % Height];
        }

        Texture large = new Texture(colors).With(SamplingOptions.Default.With(TextureFilter.Ewa));
        for (int k = 0; k < 50; k++)
        {
            TextureFootprint footprint = new(0.03125, 0.015625 * (k % 3), -0.0078125 * (k % 5), 0.125), smaller = new(0.03125 / 32, 0.015625 * (k % 3) / 32, -0.0078125 * (k % 5) / 32, 0.125 / 32);
            (double u, double v) = ((k * 0.03125) + 0.0078125, (k * 0.046875) + 0.00390625);
            Intensity expected = s_filtered.Sample(TextureLookup.At(u, v) with { Footprint = footprint });
            Intensity color = large.Sample(TextureLookup.At(u / 32, v / 32) with { Footprint = smaller });
            Assert.Equal(expected.R, color.R, 1e-5);
            Assert.Equal(expected.B, color.B, 1e-5);
        }
    }

    [Fact]
    public unsafe void Sample_NearTheEdges_ReadsNothingBesideTheTexels()
    {
        // What lies between the rows and the levels was never written: here it is not a number, and would make the mean one.
        const int Columns = 300, Rows = 200;
        TexelStore store = new(PixelBuffer.FromRgbaFloat(Columns, Rows, [.. Enumerable.Repeat(0.5f, 4 * Columns * Rows)], TransferFunction.Linear, "test"));
        FloatReader reader = new((float*)store.Samples);
        MipPyramid pyramid = new(new ReaderRows<FloatReader>(store, null, reader));
        int last = pyramid.LevelCount - 1;
        new Span<float>(pyramid.Texels, MipPyramid.Channels * (pyramid.Starts[last] + 1)).Fill(float.NaN);
        pyramid.RequirePicture();
        pyramid.Require(last, 1);
        EwaSampler<FloatReader> sampler = new(store, null, reader, SamplingOptions.Default, pyramid);
        for (int k = 0; k < 20000; k++)
        {
            // Places all over the picture, sides in all directions, up to 30 texels long.
            double Turn(double ratio) => (k * ratio) - Math.Floor(k * ratio);
            double longer = 2 + (28 * Turn(0.7548776662)), shorter = longer * Turn(0.5698402910), along = Math.Tau * Turn(0.8191725134), across = Math.Tau * Turn(0.6710436067);
            TextureFootprint footprint = new(longer * Math.Cos(along) / Columns, longer * Math.Sin(along) / Rows, shorter * Math.Cos(across) / Columns, shorter * Math.Sin(across) / Rows);
            Intensity color = ScalarSampler.Sample(sampler, TextureLookup.At(Turn(0.6180339887), Turn(0.4142135624)) with { Footprint = footprint });
            Assert.Equal(0.5, color.R, 1e-6);
        }
    }

    [Theory]
    [InlineData(64, 32)]
    [InlineData(37, 21)]
    [InlineData(5, 3)]
    public unsafe void Sample_PictureThatRepeats_AMarginChangesNoBit(int columns, int rows)
    {
        // With a margin most footprints across the ends are read as if the picture went on; without one, texel by texel where they cross.
        float[] colors = new float[4 * columns * rows];
        for (int i = 0; i < colors.Length; i++)
        {
            colors[i] = i % 4 == 3 ? 1 : (float)((i * 0.6180339887498949) % 1);
        }

        TexelStore store = new(PixelBuffer.FromRgbaFloat(columns, rows, colors, TransferFunction.Linear, "test"));
        FloatReader reader = new((float*)store.Samples);
        SamplingOptions repeats = new() { WrapU = TextureWrap.Repeat, WrapV = TextureWrap.Repeat };
        EwaSampler<FloatReader> Sampler(int margin) => new(store, null, reader, repeats, new MipPyramid(new ReaderRows<FloatReader>(store, null, reader), margin));
        EwaSampler<FloatReader> bare = Sampler(0), wide = Sampler(EwaSampler<FloatReader>.Margin);
        for (int k = 0; k < 4000; k++)
        {
            double Turn(double ratio) => (k * ratio) - Math.Floor(k * ratio);
            double longer = 1.5 + (60 * Turn(0.7548776662)), shorter = longer * Turn(0.5698402910), along = Math.Tau * Turn(0.8191725134), across = Math.Tau * Turn(0.6710436067);
            TextureFootprint footprint = new(longer * Math.Cos(along) / columns, longer * Math.Sin(along) / rows, shorter * Math.Cos(across) / columns, shorter * Math.Sin(across) / rows);
            TextureLookup lookup = TextureLookup.At(Turn(0.6180339887), Turn(0.4142135624)) with { Footprint = footprint };
            Assert.Equal(ScalarSampler.Sample(bare, lookup), ScalarSampler.Sample(wide, lookup));
        }
    }

    /// <summary>How much of a texel lies within a side.</summary>
    private static double Share(int texel, double center, double side) =>
        Math.Max(Math.Min(texel + 1, center + (side / 2)) - Math.Max(texel, center - (side / 2)), 0);

    private static double Texel(int x, int y) => s_picture.ColorMap[((x % Width) + Width) % Width, ((y % Height) + Height) % Height].G;

    private static double Sample(double x, double y, double ax, double ay, double bx, double by) => Sample(s_filtered, x, y, ax, ay, bx, by);

    private static double Sample(Texture texture, double x, double y, double ax, double ay, double bx, double by) => texture.Sample(
        new TextureLookup(new TextureCoordinate(x / Width, y / Height), WrapU: TextureWrap.Repeat, WrapV: TextureWrap.Repeat, Footprint: new TextureFootprint(ax / Width, ay / Height, bx / Width, by / Height))).G;
}
