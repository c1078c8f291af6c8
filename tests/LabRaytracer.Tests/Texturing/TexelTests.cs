namespace LabRaytracer.Tests.Texturing;

/// <summary>Which texels a coordinate falls on: lab sheet IV, section 1.1 and Program 2.</summary>
public sealed class TexelTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(7)]
    [InlineData(512)]
    public void LabNearest_IsTheCastOfProgramTwo_BitForBit(int size)
    {
        Texture columns = Ramp(size).With(new SamplingOptions { Filter = TextureFilter.Nearest, Texels = TexelConvention.Lab, WrapU = TextureWrap.Clamp });
        foreach (double u in Between(0, 1))
        {
            Assert.Equal((int)((size - 1) * u), columns.Sample(TextureLookup.At(u, 0.5)).R);
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(7)]
    [InlineData(512)]
    public void CenterNearest_IsTheFloor(int size)
    {
        Texture columns = Ramp(size).With(new SamplingOptions { Filter = TextureFilter.Nearest, WrapU = TextureWrap.Clamp });
        foreach (double u in Between(0, 1))
        {
            Assert.Equal(Math.Min(Math.Floor(size * u), size - 1), columns.Sample(TextureLookup.At(u, 0.5)).R);
        }
    }

    [Theory]
    [InlineData(TextureWrap.Repeat, -0.1, 3)]
    [InlineData(TextureWrap.Repeat, -0.26, 2)]
    [InlineData(TextureWrap.Repeat, 1, 0)]
    [InlineData(TextureWrap.Repeat, 1.3, 1)]
    [InlineData(TextureWrap.Repeat, -1e-300, 0)]
    [InlineData(TextureWrap.Clamp, -0.1, 0)]
    [InlineData(TextureWrap.Clamp, 1, 3)]
    [InlineData(TextureWrap.Clamp, 7.2, 3)]
    [InlineData(TextureWrap.Mirror, -0.1, 0)]
    [InlineData(TextureWrap.Mirror, -0.3, 1)]
    [InlineData(TextureWrap.Mirror, 1, 3)]
    [InlineData(TextureWrap.Mirror, 1.3, 2)]
    [InlineData(TextureWrap.Mirror, 2.3, 1)]
    [InlineData(TextureWrap.Border, 0, 0)]
    [InlineData(TextureWrap.Border, 1, 3)]
    [InlineData(TextureWrap.Border, -0.1, -1)]
    [InlineData(TextureWrap.Border, 1.1, -1)]
    public void Wrap_OutsideThePicture_TakesTheTexel(TextureWrap wrap, double u, int texel)
    {
        // Texel i is red i + 1, so that a border's black is told from texel 0.
        var colors = new Intensity[4, 1];
        for (int x = 0; x < 4; x++)
        {
            colors[x, 0] = Intensity.Grey(x + 1);
        }

        Texture texture = new Texture(colors).With(new SamplingOptions { Filter = TextureFilter.Nearest, WrapU = wrap });
        Assert.Equal(texel + 1, texture.Sample(TextureLookup.At(u, 0.5)).R);
    }

    [Fact]
    public void Wrap_NotChosen_IsTheMappings()
    {
        Texture texture = Ramp(4).With(new SamplingOptions { Filter = TextureFilter.Nearest });
        Assert.Equal(3, texture.Sample(new TextureLookup(new TextureCoordinate(1.1, 0), WrapU: TextureWrap.Clamp)).R);
        Assert.Equal(0, texture.Sample(new TextureLookup(new TextureCoordinate(1.1, 0), WrapU: TextureWrap.Repeat)).R);
    }

    [Theory]
    [InlineData(TexelConvention.Center, TextureWrap.Repeat)]
    [InlineData(TexelConvention.Center, TextureWrap.Clamp)]
    [InlineData(TexelConvention.Lab, TextureWrap.Clamp)]
    public void Bilinear_MatchesExactArithmetic(TexelConvention texels, TextureWrap wrap)
    {
        // Coordinates are multiples of 1/1024 and texels of 1/256, so that decimal arithmetic is exact; allowed: 3 roundings of a float below 1.
        const int Width = 5, Height = 3;
        var random = new Random(4);
        var colors = new Intensity[Width, Height];
        foreach (int i in Enumerable.Range(0, Width * Height))
        {
            colors[i % Width, i / Width] = new Intensity(random.Next(257) / 256f, random.Next(257) / 256f, random.Next(257) / 256f);
        }

        Texture texture = new Texture(colors).With(new SamplingOptions { Texels = texels, WrapU = wrap, WrapV = wrap });
        for (int i = 0; i < 1000; i++)
        {
            int u = random.Next(1025), v = random.Next(1025);
            decimal expected = Bilinear(colors, u / 1024m, v / 1024m, texels, wrap);
            float actual = texture.Sample(TextureLookup.At(u / 1024.0, v / 1024.0)).G;
            Assert.True(Math.Abs(expected - (decimal)(double)actual) <= 1.8e-7m, $"At ({u}, {v})/1024: expected {expected}, got {actual:R}.");
        }
    }

    [Fact]
    public void Bilinear_AtTexelCentres_IsTheTexel()
    {
        Texture texture = Ramp(8);
        for (int x = 0; x < 8; x++)
        {
            Assert.Equal(x, texture.Sample(TextureLookup.At((x + 0.5) / 8, 0.5)).R);
        }
    }

    private static decimal Bilinear(Intensity[,] colors, decimal u, decimal v, TexelConvention texels, TextureWrap wrap)
    {
        (int First, int Second, decimal Weight) Axis(decimal t, int size)
        {
            t = wrap == TextureWrap.Repeat ? t - decimal.Floor(t) : t;
            decimal position = texels == TexelConvention.Lab ? (size - 1) * t : (size * t) - 0.5m;
            int first = (int)decimal.Floor(position);
            int Inside(int i) => wrap == TextureWrap.Repeat ? ((i % size) + size) % size : Math.Clamp(i, 0, size - 1);
            return (Inside(first), Inside(first + 1), position - first);
        }

        var (x0, x1, right) = Axis(u, colors.GetLength(0));
        var (y0, y1, above) = Axis(v, colors.GetLength(1));
        decimal At(int x, int y) => (decimal)colors[x, y].G;
        decimal below = At(x0, y0) + ((At(x1, y0) - At(x0, y0)) * right);
        decimal top = At(x0, y1) + ((At(x1, y1) - At(x0, y1)) * right);
        return below + ((top - below) * above);
    }

    /// <summary>A texture of one row whose texel x is grey x.</summary>
    private static Texture Ramp(int size)
    {
        var colors = new Intensity[size, 1];
        for (int x = 0; x < size; x++)
        {
            colors[x, 0] = Intensity.Grey(x);
        }

        return new Texture(colors);
    }

    /// <summary>Both ends, their neighbours, and random numbers between them.</summary>
    private static IEnumerable<double> Between(double low, double high)
    {
        var random = new Random(2);
        double[] ends = [low, Math.BitIncrement(low), Math.BitDecrement(high), high];
        return ends.Concat(Enumerable.Range(0, 2000).Select(_ => low + ((high - low) * random.NextDouble())));
    }
}
