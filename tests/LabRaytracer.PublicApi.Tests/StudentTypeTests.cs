namespace LabRaytracer.PublicApi.Tests;

/// <summary>The types of docs/extending.md, rendered.</summary>
public sealed class StudentTypeTests
{
    [Fact]
    public void MyCylindricalMapping_LooksLikeTheBuiltInOne()
    {
        Picture Show(IMapping mapping) => Render(new Cylinder(), new TextureSlot { Texture = new UvColors(), Mapping = mapping });
        Assert.InRange(PictureDifference.Compare(Show(new CylindricalMapping()), Show(new MyCylindricalMapping())).Max, 0, 1e-6);
    }

    [Fact]
    public void Rings_AreSeenOnAQuad()
    {
        Scene scene = new() { Camera = new OrthographicCamera(new Point3D(0, 5, 0), Point3D.Origin, 2, Vector3D.UnitX) };
        scene.Add(new Quad(), new Material { Diffuse = Intensity.Black, Emission = TextureSlot.Of(new Rings(Intensity.White, Intensity.Black, 4)) });
        Picture picture = Renderer.Render(scene, new RenderOptions { Width = 64, Height = 64 }).Picture;
        Assert.Equal(Intensity.White, picture[32, 32]);
        Assert.Equal(Intensity.Black, picture[32 + 12, 32]);
        Assert.Equal(Intensity.White, picture[32, 32 + 20]);
    }

    [Fact]
    public void MySphere_LooksLikeTheBuiltInOne()
    {
        // Silhouette pixels may fall on either side; everything else agrees.
        Picture own = Render(new MySphere(), TextureSlot.Of(new UvColors())), builtIn = Render(new Sphere(), TextureSlot.Of(new UvColors()));
        int different = 0;
        for (int i = 0; i < own.Pixels.Length; i++)
        {
            different += (own.Pixels[i] - builtIn.Pixels[i]).Max is > 1e-5f or < -1e-5f ? 1 : 0;
        }

        Assert.InRange(different, 0, 2);
    }

    [Fact]
    public void Ceiling_LightsWhatLiesBelow()
    {
        Scene scene = new();
        scene.Add(new Sphere(), new Material { Diffuse = Intensity.White });
        scene.Lights.Add(new Ceiling(0.5, Intensity.White));
        Picture picture = Renderer.Render(scene, new RenderOptions { Width = 60, Height = 60 }).Picture;
        Assert.InRange(picture[30, 24].R, 0.1f, 0.5f);
        Assert.Equal(Intensity.Black, picture[30, 16]);
    }

    [Fact]
    public void ToonShader_HasItsStepsAndNoOthers()
    {
        Scene scene = new();
        scene.Add(new Sphere(), new Material { Shader = new ToonShader(2) });
        scene.Lights.Add(new DirectionalLight(-Vector3D.UnitZ, Intensity.White));
        Picture picture = Renderer.Render(scene, new RenderOptions { Width = 60, Height = 60 }).Picture;
        Assert.Equal([0, 0.5f, 1], picture.Pixels.ToArray().Select(pixel => pixel.G).Distinct().Order());
    }

    [Fact]
    public void Fisheye_SeesHalfTheWorld()
    {
        Scene scene = new() { Camera = new Fisheye(Point3D.Origin, 180), Background = TextureSlot.Of(new UvColors()) };
        Picture picture = Renderer.Render(scene, new RenderOptions { Width = 101, Height = 101 }).Picture;
        Assert.Equal(0.5, picture[50, 50].R, 6);
        Assert.Equal(0.5, picture[50, 50].G, 6);
        Assert.InRange(picture[50, 0].G, 0.99f, 1);
        Assert.Equal(0.25, picture[100, 50].R, 0.01);
    }

    private static Picture Render(Shape shape, TextureSlot emission)
    {
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(2, 1.5, -3), Point3D.Origin, 45) };
        scene.Add(shape, new Material { Diffuse = Intensity.Black, Emission = emission });
        return Renderer.Render(scene, new RenderOptions { Width = 80, Height = 60 }).Picture;
    }

    /// <summary>Texture coordinates as a colour.</summary>
    private sealed class UvColors : ITexture
    {
        public Intensity Sample(in TextureLookup lookup) => new((float)lookup.Coordinate.U, (float)lookup.Coordinate.V, 0.5f);
    }
}
