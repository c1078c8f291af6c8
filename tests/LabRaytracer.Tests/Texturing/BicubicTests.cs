using LabRaytracer.Tests.Rendering;

namespace LabRaytracer.Tests.Texturing;

/// <summary>Lookups of 4 x 4 texels by Catmull-Rom and B-spline kernels.</summary>
public sealed class BicubicTests
{
    private const float Unit = 1f / (1 << 24);

    private static readonly float[] s_row = [0.125f, 0.875f, 0.25f, 0.5f, 0.75f];

    // mpmath, 60 digits: sum of k(x_i - x) t_i over the texels of the row above, kept inside their range.
    [Theory]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Repeat, 0.03125, 0.27199172973632813)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Repeat, 0.4375, 0.426849365234375)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Repeat, 0.96875, 0.54661178588867188)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Repeat, -0.21875, 0.64443397521972656)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Repeat, 0.6875, 0.4827728271484375)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Repeat, 1.15625, 0.27513504028320313)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Mirror, 0.03125, 0.125)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Mirror, 0.4375, 0.426849365234375)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Mirror, 0.96875, 0.75)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Mirror, -0.21875, 0.63202857971191406)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Mirror, 0.6875, 0.4827728271484375)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Mirror, 1.15625, 0.69784927368164063)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Clamp, 0.03125, 0.125)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Clamp, 0.4375, 0.426849365234375)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Clamp, 0.96875, 0.75)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Clamp, -0.21875, 0.125)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Clamp, 0.6875, 0.4827728271484375)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Clamp, 1.15625, 0.75)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Border, 0.03125, 0.125)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Border, 0.4375, 0.426849365234375)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Border, 0.96875, 0.75)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Border, -0.21875, 0.0)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Border, 0.6875, 0.4827728271484375)]
    [InlineData(TextureFilter.CatmullRom, TextureWrap.Border, 1.15625, 0.0)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Repeat, 0.03125, 0.39868799845377604)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Repeat, 0.4375, 0.48570760091145833)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Repeat, 0.96875, 0.50324885050455729)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Repeat, -0.21875, 0.59178479512532552)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Repeat, 0.6875, 0.48441060384114583)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Repeat, 1.15625, 0.41593043009440104)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Mirror, 0.03125, 0.1654052734375)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Mirror, 0.4375, 0.48570760091145833)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Mirror, 0.96875, 0.73653157552083333)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Mirror, -0.21875, 0.53072420756022135)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Mirror, 0.6875, 0.48441060384114583)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Mirror, 1.15625, 0.66421635945638021)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Clamp, 0.03125, 0.16032791137695313)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Clamp, 0.4375, 0.48570760091145833)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Clamp, 0.96875, 0.73822402954101563)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Clamp, -0.21875, 0.140625)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Clamp, 0.6875, 0.48441060384114583)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Clamp, 1.15625, 0.74479166666666667)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Border, 0.03125, 0.16032791137695313)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Border, 0.4375, 0.48570760091145833)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Border, 0.96875, 0.73822402954101563)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Border, -0.21875, 0.0)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Border, 0.6875, 0.48441060384114583)]
    [InlineData(TextureFilter.BSpline, TextureWrap.Border, 1.15625, 0.0)]
    public void Sample_RowOfTexels_MatchesMpmath(TextureFilter filter, TextureWrap wrap, double u, double expected)
    {
        var colors = new Intensity[5, 1];
        for (int x = 0; x < 5; x++)
        {
            colors[x, 0] = Intensity.Grey(s_row[x]);
        }

        Texture texture = new Texture(colors).With(new SamplingOptions { Filter = filter, WrapU = wrap });
        Assert.Equal(expected, texture.Sample(TextureLookup.At(u, 0.5)).G, 12 * Unit);
    }

    [Theory]
    [InlineData(TextureFilter.CatmullRom, 0.0, 0.5)]
    [InlineData(TextureFilter.BSpline, 1.0, 0.0)]
    public void Sample_Picture_IsTheConvolutionWithMitchellNetravalisKernel(TextureFilter filter, double b, double c)
    {
        // A bright picture on a steep slope without extrema, so that nothing leaves the range of the texels.
        const int Width = 6, Height = 5;
        var colors = new Intensity[Width, Height];
        for (int i = 0; i < Width * Height; i++)
        {
            (int x, int y) = (i % Width, i / Width);
            colors[x, y] = new Intensity((x * x * 0.01f) + (y * 0.1f), y * y * y * 0.007f, 0.5f + (x * 0.03f) - (y * 0.02f));
        }

        Texture texture = new Texture(colors).With(new SamplingOptions { Filter = filter, WrapU = TextureWrap.Clamp, WrapV = TextureWrap.Clamp });
        foreach ((double u, double v) in new[] { (0.4, 0.5), (0.61, 0.43), (0.35, 0.52), (0.5, 0.5), (0.27, 0.59) })
        {
            double sum = 0;
            for (int i = 0; i < Width * Height; i++)
            {
                (int x, int y) = (i % Width, i / Width);
                sum += colors[x, y].G * Kernel((u * Width) - 0.5 - x, b, c) * Kernel((v * Height) - 0.5 - y, b, c);
            }

            Assert.Equal(sum, texture.Sample(TextureLookup.At(u, v)).G, 24 * Unit);
        }
    }

    [Theory]
    [InlineData(TextureFilter.CatmullRom)]
    [InlineData(TextureFilter.BSpline)]
    public void Sample_ConstantPicture_IsTheConstantToTheBit(TextureFilter filter)
    {
        var colors = new Intensity[7, 3];
        for (int i = 0; i < 21; i++)
        {
            colors[i % 7, i / 7] = new Intensity(0.1f, 0.3f, 0.7f);
        }

        Texture texture = new Texture(colors).With(new SamplingOptions { Filter = filter });
        for (int i = 0; i < 200; i++)
        {
            Assert.Equal(new Intensity(0.1f, 0.3f, 0.7f), texture.Sample(TextureLookup.At(i * 0.017, i * 0.013)));
        }
    }

    [Fact]
    public void CatmullRom_AtTexelCentres_IsTheTexel()
    {
        Texture texture = TestScenes.Random(8, 4).With(new SamplingOptions { Filter = TextureFilter.CatmullRom });
        for (int i = 0; i < 32; i++)
        {
            Assert.Equal(texture.ColorMap[i % 8, i / 8], texture.Sample(TextureLookup.At(((i % 8) + 0.5) / 8, ((i / 8) + 0.5) / 4)));
        }
    }

    [Fact]
    public void CatmullRom_BesideAnEdge_OvershootsInSlotsOfNumbersOnly()
    {
        // Texels 0 0 1 1; half a texel before the edge the cubic is -1/16 of the step, as far behind it 17/16.
        var colors = new Intensity[4, 1];
        (colors[2, 0], colors[3, 0]) = (Intensity.White, Intensity.White);
        Texture texture = new Texture(colors).With(new SamplingOptions { Filter = TextureFilter.CatmullRom, WrapU = TextureWrap.Clamp });
        TextureLookup[] lookups = [TextureLookup.At(1 / 4.0, 0.5), TextureLookup.At(3 / 4.0, 0.5)];
        Intensity[] Sample(bool isData) => SamplerRun.Sample<Double4, Float4, Int4>(((IPreparedTexture)texture).Prepare(isData ? TextureUse.Data : TextureUse.Color, null), lookups);
        Assert.Equal([Intensity.Grey(-0.0625f), Intensity.Grey(1.0625f)], Sample(isData: true));
        Assert.Equal([Intensity.Black, Intensity.White], Sample(isData: false));
    }

    [Fact]
    public void Texture_EveryFormatAndWrap_SameAsScalar()
    {
        foreach (Texture texture in StoreTests.EveryFormat(5, 3))
        {
            foreach (TextureWrap wrap in Enum.GetValues<TextureWrap>())
            {
                foreach (TextureFilter filter in new[] { TextureFilter.CatmullRom, TextureFilter.BSpline })
                {
                    TexelConvention texels = wrap == TextureWrap.Mirror ? TexelConvention.Lab : TexelConvention.Center;
                    SamplerRun.SameAsScalar(texture.With(new SamplingOptions { Filter = filter, Texels = texels, WrapV = wrap }), wrap, TextureWrap.Repeat);
                }
            }
        }
    }

    /// <summary>Mitchell and Netravali 1988, equation 8, as printed.</summary>
    private static double Kernel(double x, double b, double c)
    {
        double t = Math.Abs(x);
        return t < 1 ? ((((12 - (9 * b) - (6 * c)) * t * t * t) + ((-18 + (12 * b) + (6 * c)) * t * t)) + 6 - (2 * b)) / 6
            : t < 2 ? (((-b - (6 * c)) * t * t * t) + (((6 * b) + (30 * c)) * t * t) + (((-12 * b) - (48 * c)) * t) + (8 * b) + (24 * c)) / 6
            : 0;
    }
}
