namespace LabRaytracer.Tests.Rendering;

/// <summary>What a scene does not need is not done.</summary>
public sealed class NothingInVainTests
{
    [Fact]
    public void ConstantScene_NoMappingsAndNoLookups()
    {
        RenderStatistics statistics = Count(new Material { Diffuse = TextureSlot.Of(new ConstantTexture(Intensity.Grey(0.5f))), Emission = Intensity.Grey(0.1f) });
        Assert.Equal((0, 0, 0), (statistics.Mappings, statistics.TextureLookups, statistics.Textures));
        Assert.Equal(400, statistics.PrimaryRays);
        Assert.True(statistics.ConstantSlots >= 400);
    }

    [Fact]
    public void VolumeTexture_NoMappings()
    {
        RenderStatistics statistics = Count(Material.Matte(new CheckerTexture { Space = CheckerSpace.Local }));
        Assert.Equal((0, 400), (statistics.Mappings, statistics.TextureLookups));
    }

    [Fact]
    public void SameTextureInThreeSlots_OneMappingAndOneLookupAHit()
    {
        Texture texture = TestScenes.Random(4, 4);
        RenderStatistics statistics = Count(new Material { Diffuse = texture, Emission = texture, Ambient = texture });
        Assert.Equal((400, 400, 1), (statistics.Mappings, statistics.TextureLookups, statistics.Textures));
    }

    [Fact]
    public void TwoTexturesOfOneMapping_OneMappingAHit()
    {
        RenderStatistics statistics = Count(new Material { Diffuse = TestScenes.Random(4, 4), Emission = TestScenes.Random(2, 2) });
        Assert.Equal((400, 800), (statistics.Mappings, statistics.TextureLookups));
    }

    [Fact]
    public void CorruptFile_ThatNoPixelCanShow_IsNotOpened()
    {
        using TestFolder folder = new();
        File.WriteAllText(folder["bad.png"], "this is no picture");
        var bad = Texture.Load(folder["bad.png"]);
        _ = new Material { Diffuse = bad };
        Count(new Material { Specular = bad, Shader = LambertShader.Default });
        Count(new Material { Diffuse = new TextureSlot { Texture = bad, Amount = 0 } });
        Count(new Material { Diffuse = new TextureSlot { Texture = bad, Value = Intensity.Black } });
        Count(new Material { Shininess = new ScalarSlot { Texture = bad, Value = 10 } });
        Count(new Material { IndexOfRefraction = new ScalarSlot { Texture = bad, Value = 1.5f } });
        PictureFormatException failure = Assert.Throws<PictureFormatException>(() => Count(new Material { Diffuse = bad }));
        Assert.Contains("bad.png", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void LightBehindTheSurface_NoShadowRays()
    {
        Scene scene = TestScenes.QuadFromAbove(new Material());
        scene.Lights.Add(new PointLight(new Point3D(0, -3, 0), Intensity.White));
        scene.Lights.Add(new DirectionalLight(Vector3D.UnitY, Intensity.White));
        scene.Lights.Add(new PointLight(new Point3D(0, 3, 0), Intensity.Black));
        RenderStatistics statistics = Renderer.Render(scene, new RenderOptions { Width = 20, Height = 20 }).Statistics;
        Assert.Equal((0, 1200), (statistics.ShadowRays, statistics.ShadowRaysSkipped));
    }

    private static RenderStatistics Count(Material material) =>
        Renderer.Render(TestScenes.QuadFromAbove(material), new RenderOptions { Width = 20, Height = 20 }).Statistics;
}
