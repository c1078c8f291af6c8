namespace LabRaytracer.Tests.Rendering;

/// <summary>Skipping leaves out work that cannot change the picture, and says how much.</summary>
public sealed class SkippingTests
{
    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Single)]
    public void Off_SceneWithEverything_SameBitsAndMoreWork(Precision precision)
    {
        RenderResult on = Render(TestScenes.Everything(), precision, Skipping.On), off = Render(TestScenes.Everything(), precision, Skipping.Off);
        PictureAssert.SameBits(on.Picture, off.Picture);
        Assert.True(on.Statistics.ShadowRaysSkipped > 0);
        Assert.Equal(0, off.Statistics.ShadowRaysSkipped);
        Assert.True(off.Statistics.ShadowRays >= on.Statistics.ShadowRays + on.Statistics.ShadowRaysSkipped);
        Assert.True(off.Statistics.TextureLookups > on.Statistics.TextureLookups);
        Assert.True(off.Statistics.ConstantSlots < on.Statistics.ConstantSlots);
    }

    [Fact]
    public void Off_FaintMirror_FollowedWithoutEffect()
    {
        RenderResult on = Render(FaintMirror(), Precision.Double, Skipping.On), off = Render(FaintMirror(), Precision.Double, Skipping.Off);
        PictureAssert.SameBits(on.Picture, off.Picture);
        Assert.Equal((0, 576), (on.Statistics.SecondaryRays, on.Statistics.SecondaryRaysSkipped));
        Assert.Equal((576, 0), (off.Statistics.SecondaryRays, off.Statistics.SecondaryRaysSkipped));
    }

    [Fact]
    public void Off_BlackSurface_ShadowRaysWithoutEffect()
    {
        Scene Black()
        {
            Scene scene = TestScenes.QuadFromAbove(new Material { Diffuse = Intensity.Black, Shader = LambertShader.Default, Emission = Intensity.Grey(0.25f) });
            scene.Lights.Add(new PointLight(new Point3D(0, 3, 0), Intensity.White));
            return scene;
        }

        RenderResult on = Render(Black(), Precision.Double, Skipping.On), off = Render(Black(), Precision.Double, Skipping.Off);
        PictureAssert.SameBits(on.Picture, off.Picture);
        Assert.Equal((0, 576), (on.Statistics.ShadowRays, on.Statistics.UnlitHits));
        Assert.Equal(576, off.Statistics.ShadowRays);
    }

    [Fact]
    public void Skipped_TextureThatNoPixelCanShow_IsCounted()
    {
        Material material = new() { Diffuse = Intensity.White, Specular = TestScenes.Random(4, 4), Shader = LambertShader.Default };
        RenderStatistics on = Render(TestScenes.QuadFromAbove(material), Precision.Double, Skipping.On).Statistics;
        RenderStatistics off = Render(TestScenes.QuadFromAbove(material), Precision.Double, Skipping.Off).Statistics;
        Assert.Equal((0, 1), (on.Textures, on.TexturesSkipped));
        Assert.Equal(0, off.TexturesSkipped);
        SkippedWork textures = on.Skipped[^1];
        Assert.Equal((1L, null), (textures.Count, textures.Seconds));
    }

    [Fact]
    public void Skipped_EveryItem_CostsCountTimesMeanOfItsKind()
    {
        RenderStatistics statistics = new() { ShadowRays = 200, ShadowRaysSkipped = 50, StageSeconds = new Dictionary<string, double> { ["Light"] = 4 } };
        SkippedWork shadows = statistics.Skipped[1];
        Assert.Equal((50L, 1.0), (shadows.Count, shadows.Seconds));
        Assert.Null(statistics.Skipped[0].Seconds);
    }

    private static Scene FaintMirror()
    {
        Scene scene = TestScenes.QuadFromAbove(new Material { Diffuse = Intensity.Grey(0.5f), Reflection = Intensity.Grey(1f / 8192) });
        scene.Background = Intensity.White;
        return scene;
    }

    private static RenderResult Render(Scene scene, Precision precision, Skipping skipping) =>
        Renderer.Render(scene, new RenderOptions { Width = 24, Height = 24, Precision = precision, Skipping = skipping });
}
