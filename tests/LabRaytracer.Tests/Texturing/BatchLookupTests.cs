namespace LabRaytracer.Tests.Texturing;

/// <summary>Many lookups at a time give the bits of one at a time, at every vector width.</summary>
public sealed class BatchLookupTests
{
    private static readonly TextureWrap[] s_wraps = Enum.GetValues<TextureWrap>();

    [Theory]
    [InlineData(TextureFilter.Nearest, TexelConvention.Center)]
    [InlineData(TextureFilter.Nearest, TexelConvention.Lab)]
    [InlineData(TextureFilter.Bilinear, TexelConvention.Center)]
    [InlineData(TextureFilter.Bilinear, TexelConvention.Lab)]
    public void Texture_EveryFormatAndWrap_SameAsScalar(TextureFilter filter, TexelConvention texels)
    {
        foreach (Texture texture in StoreTests.EveryFormat(5, 3))
        {
            foreach (TextureWrap wrap in s_wraps)
            {
                SamplerRun.SameAsScalar(texture.With(new SamplingOptions { Filter = filter, Texels = texels, WrapV = wrap }), wrap, TextureWrap.Repeat);
            }
        }
    }

    [Theory]
    [InlineData(TextureFilter.Nearest)]
    [InlineData(TextureFilter.Bilinear)]
    public void Texture_LargePicture_SameAsScalar(TextureFilter filter)
    {
        // More than 65536 texels: they are asked for ahead.
        foreach (Texture texture in StoreTests.EveryFormat(320, 256))
        {
            SamplerRun.SameAsScalar(texture.With(new SamplingOptions { Filter = filter }), TextureWrap.Repeat, TextureWrap.Clamp);
        }
    }

    [Fact]
    public void Texture_OneTexel_IsConstantWhereTheWrapHasAPicture()
    {
        var texture = new Texture(new[,] { { new Intensity(1, 2, 3) } });
        foreach (TextureWrap wrap in new[] { TextureWrap.Repeat, TextureWrap.Clamp, TextureWrap.Mirror })
        {
            Assert.All(SamplerRun.Lookups(wrap, wrap), lookup => Assert.Equal(new Intensity(1, 2, 3), texture.Sample(lookup)));
        }
    }

    [Fact]
    public void Checker_BothSpaces_SameAsScalar()
    {
        SamplerRun.SameAsScalar(new CheckerTexture { Columns = 3, Rows = 5, LineWidth = 0.1, Line = new Intensity(1, 0, 0) }, TextureWrap.Repeat, TextureWrap.Repeat);
        SamplerRun.SameAsScalar(new CheckerTexture { Space = CheckerSpace.Local, Columns = 2, Rows = 3 }, TextureWrap.Repeat, TextureWrap.Repeat);
    }

    [Theory]
    [InlineData(TextureWrap.Repeat)]
    [InlineData(TextureWrap.Clamp)]
    public void Grid_SameAsScalar(TextureWrap wrapV) => SamplerRun.SameAsScalar(new GridTexture(), TextureWrap.Repeat, wrapV);
}
