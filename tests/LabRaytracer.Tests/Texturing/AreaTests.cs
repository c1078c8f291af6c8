using LabRaytracer.Tests.Rendering;

namespace LabRaytracer.Tests.Texturing;

/// <summary>Exact means of a bilinear picture over the footprints of samples.</summary>
public sealed class AreaTests
{
    [Fact]
    public void Area_PictureOfAProduct_IsTheIntegral()
    {
        // Texel (x, y) is x y: bilinear lookup gives it everywhere between centres, and its mean is c_x c_y + (a_x a_y + b_x b_y) / 12.
        Intensity[,] product = new Intensity[40, 40];
        for (int i = 0; i < 1600; i++)
        {
            product[i % 40, i / 40] = Intensity.Grey(i % 40 * (i / 40));
        }

        Texture texture = Of(new Texture(product));
        Random random = new(3);
        for (int k = 0; k < 50; k++)
        {
            double Side() => (random.NextDouble() - 0.5) * 12;
            (double ax, double ay, double bx, double by) = ((float)(Side() / 40), (float)(Side() / 40), (float)(Side() / 40), (float)(Side() / 40));
            Intensity mean = texture.Sample(TextureLookup.At(20.3 / 40, 19.1 / 40) with { Footprint = new TextureFootprint(ax, ay, bx, by) });
            double expected = (19.8 * 18.6) + (((ax * ay) + (bx * by)) * 1600 / 12);
            Assert.Equal(expected, mean.R, 1e-6 * 400);
        }
    }

    [Fact]
    public void Area_ManyPoints_IsTheirMean()
    {
        Texture picture = TestScenes.Random(16, 16), bilinear = picture.With(SamplingOptions.Default.With(TextureFilter.Bilinear));
        TextureFootprint footprint = new(0.11, 0.04, -0.03, 0.07);
        double sum = 0;
        const int Side = 300;
        for (int i = 0; i < Side * Side; i++)
        {
            double s = (((i % Side) + 0.5) / Side) - 0.5, t = (((i / Side) + 0.5) / Side) - 0.5;
            sum += bilinear.Sample(TextureLookup.At(0.02 + (s * footprint.DuDx) + (t * footprint.DuDy), 0.4 + (s * footprint.DvDx) + (t * footprint.DvDy))).R;
        }

        Assert.Equal(sum / (Side * Side), Of(picture).Sample(TextureLookup.At(0.02, 0.4) with { Footprint = footprint }).R, 1e-5);
    }

    /// <summary>Footprints along a picture of one row, of parts of it up to thousands of periods: the integral of the broken line between its texels, which the trapezoid rule has exactly.</summary>
    [Theory]
    [InlineData(TextureWrap.Repeat)]
    [InlineData(TextureWrap.Mirror)]
    [InlineData(TextureWrap.Clamp)]
    public void Area_AnyLength_IsTheIntegralOfTheBrokenLine(TextureWrap wrap)
    {
        const int Width = 5;
        Texture row = TestScenes.Random(Width, 1);
        double At(int column)
        {
            int turn = ((column % (2 * Width)) + (2 * Width)) % (2 * Width);
            return row.ColorMap[
                wrap switch
                {
                    TextureWrap.Repeat => turn % Width,
                    TextureWrap.Mirror => Math.Min(turn, (2 * Width) - 1 - turn),
                    _ => Math.Clamp(column, 0, Width - 1),
                },
                0].R;
        }

        double Line(double x) => At((int)Math.Floor(x)) + ((x - Math.Floor(x)) * (At((int)Math.Floor(x) + 1) - At((int)Math.Floor(x))));
        foreach (double length in new[] { 0.4, 1.7, 5, 7.25, 10, 23.5, 61, 1000.125, 30000.75 })
        {
            // Where texel centres are whole numbers; all numbers are exact in binary or rounded once.
            double low = (0.3125 * Width) - 0.5 - (length / 2), high = low + length, sum = 0;
            for (double x = low; x < high; x = Math.Floor(x) + 1)
            {
                double next = Math.Min(Math.Floor(x) + 1, high);
                sum += (next - x) * (Line(x) + Line(next)) / 2;
            }

            TextureLookup lookup = TextureLookup.At(0.3125, 0.5) with { Footprint = new TextureFootprint(length / Width, 0, 0, 0.25), WrapU = wrap, WrapV = TextureWrap.Clamp };
            Assert.Equal(sum / length, Of(row).Sample(lookup).R, 2e-6);
        }
    }

    private static Texture Of(Texture texture) => texture.With(SamplingOptions.Default.With(TextureFilter.Area));
}
