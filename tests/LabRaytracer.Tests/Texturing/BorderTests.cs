using LabRaytracer.Tests.Rendering;

namespace LabRaytracer.Tests.Texturing;

/// <summary>What a texture shows beyond a border.</summary>
public sealed class BorderTests
{
    private static readonly Intensity s_border = new(0.125f, 0.5f, 3);

    public static TheoryData<TextureFilter> Filters => [.. Enum.GetValues<TextureFilter>()];

    /// <summary>Inside what the texture shows without a border, outside the border colour; its alpha ends at the border whatever the colour.</summary>
    [Theory]
    [MemberData(nameof(Filters))]
    public void BorderColor_EveryFilter_IsShownOutsideAndThereOnly(TextureFilter filter)
    {
        Texture Wrapped(TextureWrap wrap) => Of(filter, wrap);
        foreach ((double u, double v, bool isInside) in new[] { (0.5, 0.5, true), (0, 1, true), (1, 0, true), (-0.001, 0.5, false), (0.5, 1.001, false), (7, -3, false), (-1e300, 0.5, false) })
        {
            TextureLookup lookup = TextureLookup.At(u, v);
            Assert.Equal(isInside ? Wrapped(TextureWrap.Clamp).Sample(lookup) : s_border, Wrapped(TextureWrap.Border).Sample(lookup));
            Assert.Equal(isInside ? 1 : 0, Wrapped(TextureWrap.Border).Alpha(lookup));
        }
    }

    [Theory]
    [MemberData(nameof(Filters))]
    public void BorderColor_EveryWidth_SameBitsAsSingleCall(TextureFilter filter) =>
        SamplerRun.SameAsScalar(Of(filter, TextureWrap.Border), SamplerRun.FootprintLookups(TextureWrap.Repeat, TextureWrap.Repeat));

    /// <summary>A wrap that is the mapping's counts as well; another wrap of the mapping leaves the colour alone.</summary>
    [Theory]
    [InlineData(TextureWrap.Border)]
    [InlineData(TextureWrap.Repeat)]
    public void BorderColor_WrapOfTheMapping_Decides(TextureWrap byMapping)
    {
        Texture texture = Of(TextureFilter.Nearest, null);
        SamplerRun.SameAsScalar(texture, byMapping, TextureWrap.Clamp);
        Intensity outside = texture.Sample(new TextureLookup(new TextureCoordinate(1.5, 0.5), WrapU: byMapping, WrapV: TextureWrap.Clamp));
        Assert.Equal(byMapping == TextureWrap.Border, outside == s_border);
    }

    /// <summary>In layers a border covers nothing, so its colour is not seen there.</summary>
    [Fact]
    public void BorderColor_InLayers_ShowsWhatIsBelow()
    {
        Texture cover = Of(TextureFilter.Bilinear, TextureWrap.Border);
        LayeredTexture layers = new(new ConstantTexture(new Intensity(0.25f, 0.75f, 0.5f)), [new TextureCover(cover)]);
        Assert.Equal(new Intensity(0.25f, 0.75f, 0.5f), layers.Sample(TextureLookup.At(1.25, 0.5)));
        SamplerRun.SameAsScalar(layers, TextureWrap.Repeat, TextureWrap.Repeat);
    }

    /// <summary>A material whose diffuse slot is a picture with a coloured border, in a whole render: a quad twice as wide as its picture.</summary>
    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Single)]
    public void BorderColor_InAPicture_IsSeen(Precision precision)
    {
        UvTransform twice = new(default, 0, new TextureCoordinate(2, 1), default);
        TextureSlot slot = new() { Value = Intensity.White, Texture = Of(TextureFilter.Nearest, TextureWrap.Border), Transform = twice };
        Scene scene = new() { Camera = TestScenes.AboveQuad() };
        scene.Add(new Quad(), TestScenes.Shining(slot));
        RenderResult result = Renderer.Render(scene, new RenderOptions { Width = 20, Height = 20, Precision = precision });
        Assert.Equal(200, Enumerable.Range(0, 400).Count(i => result.Picture[i % 20, i / 20] == s_border));
    }

    /// <summary>Footprints that are too long for their width are counted where a texture is part of another one, too.</summary>
    [Fact]
    public void Fallbacks_OfPartsOfTextures_AreCounted()
    {
        Texture picture = Of(TextureFilter.Ewa, TextureWrap.Repeat, 1024);
        TextureLookup[] lookups = [.. Enumerable.Range(0, 16).Select(i => TextureLookup.At(i / 16.0, 0.5) with { Footprint = new TextureFootprint(0.5, 0, 0, 1e-4) })];
        foreach (ITexture texture in new ITexture[]
        {
            picture, new TransformedTexture(picture) { Uv = new UvTransform(new TextureCoordinate(0.5, 0), 0, new TextureCoordinate(1, 1), default) },
            new ProductTexture(picture, Of(TextureFilter.Nearest, null)), new MixTexture(picture, new ConstantTexture(Intensity.White), new ConstantTexture(Intensity.Grey(0.5f))),
        })
        {
            TextureSampler sampler = ((IPreparedTexture)texture).Prepare(TextureUse.Color, filter: null);
            SamplerRun.Sample<Double8, Float8, Int8>(sampler, lookups);
            Assert.Equal(16, sampler.Fallbacks);
        }
    }

    private static Texture Of(TextureFilter filter, TextureWrap? wrap, int size = 5) =>
        TestScenes.Random(size, size).With(new SamplingOptions { Filter = filter, WrapU = wrap, WrapV = wrap, BorderColor = s_border });
}
