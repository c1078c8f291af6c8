namespace LabRaytracer.PublicApi.Tests;

/// <summary>What a student writes takes part with the same bits as what is built in: one at a time equals many at a time.</summary>
public sealed class BorrowedTypeTests
{
    [Fact]
    public void Shapes_SameBits() => SameBits(Scene(), Scene(shape: lender => new BorrowedShape(lender, lender.DefaultMapping)));

    [Fact]
    public void Mappings_SameBits() => SameBits(Scene(), Scene(mapping: lender => new BorrowedMapping(lender)));

    [Fact]
    public void Textures_SameBits() => SameBits(Scene(), Scene(texture: lender => new BorrowedTexture(lender)));

    [Fact]
    public void Lights_SameBits() => SameBits(Scene(), Scene(light: lender => new BorrowedLight(lender)));

    [Fact]
    public void Shaders_SameBits() => SameBits(Scene(), Scene(shader: lender => new BorrowedShader(lender)));

    [Fact]
    public void Cameras_SameBits() => SameBits(Scene(), Scene(camera: lender => new BorrowedCamera(lender)));

    [Fact]
    public void Everything_SameBits() => SameBits(
        Scene(),
        Scene(
            lender => new BorrowedShape(lender, new BorrowedMapping(lender.DefaultMapping)),
            lender => new BorrowedMapping(lender),
            lender => new BorrowedTexture(lender),
            lender => new BorrowedLight(lender),
            lender => new BorrowedShader(lender),
            lender => new BorrowedCamera(lender)));

    private static void SameBits(Scene builtIn, Scene borrowed)
    {
        RenderOptions options = new() { Width = 90, Height = 60 };
        Picture expected = Renderer.Render(builtIn, options).Picture, actual = Renderer.Render(borrowed, options).Picture;
        for (int y = 0; y < expected.Height; y++)
        {
            for (int x = 0; x < expected.Width; x++)
            {
                Assert.True(expected[x, y] == actual[x, y], $"Pixel ({x}, {y}): {expected[x, y]} built in, {actual[x, y]} borrowed.");
            }
        }
    }

    /// <summary>A scene with every kind of built-in part, each of which may be replaced.</summary>
    private static Scene Scene(
        Func<Shape, Shape>? shape = null,
        Func<IMapping, IMapping>? mapping = null,
        Func<ITexture, ITexture>? texture = null,
        Func<Light, Light>? light = null,
        Func<IShader, IShader>? shader = null,
        Func<Camera, Camera>? camera = null)
    {
        T Part<T>(T part, Func<T, T>? replace) => replace is null ? part : replace(part);
        TextureSlot Textured(ITexture picture, IMapping? own) => new() { Texture = Part(picture, texture), Mapping = own is null ? null : Part(own, mapping) };
        Scene scene = new()
        {
            Camera = Part(new PerspectiveCamera(new Point3D(0.5, 1.5, 6), Point3D.Origin, 40), camera),
            Background = new Intensity(0.1f, 0.1f, 0.2f),
        };
        scene.Lights.Add(Part(new PointLight(new Point3D(3, 5, 4), Intensity.White) { Attenuation = new Attenuation(1, 0.01, 0.02) }, light));
        scene.Lights.Add(Part(new DirectionalLight(new Vector3D(1, -1, -2), Intensity.Grey(0.4f)), light));
        scene.Lights.Add(Part(new SpotLight(new Point3D(-4, 4, 2), Point3D.Origin, Intensity.Grey(0.7f), 35, 20), light));
        Transform turned = Transform.Rotation(new Vector3D(1, 3, -2), 70).Then(Transform.Translation(new Vector3D(-1.2, 0.2, 0.3)));
        (Shape Shape, ITexture Texture, IMapping? Mapping, IShader Shader, Transform Place)[] things =
        [
            (new Sphere(), Colors(), new SphericalMapping(), PhongShader.Default, turned),
            (new Sphere(new Point3D(1.2, 0, 0.4), 0.8), new GridTexture(), null, LambertShader.Default, Transform.Identity),
            (new InfinitePlane(new Point3D(0, -1, 0), Vector3D.UnitY), new CheckerTexture { Columns = 1, Rows = 1 }, new RectangularMapping(), BlinnPhongShader.Default, Transform.Identity),
            (new Cylinder(), Colors(), new CylindricalMapping(), PhongShader.Default, Transform.Scaling(new Vector3D(0.4, 0.5, 0.4)).Then(Transform.Translation(new Vector3D(0, 0, 2)))),
            (new Box(), new CheckerTexture { Space = CheckerSpace.Local }, new BoxMapping(), PhongShader.Default, Transform.Scaling(new Vector3D(0.3, 0.3, 0.3)).Then(turned).Then(Transform.Translation(new Vector3D(2, 1, 1)))),
        ];
        foreach ((Shape part, ITexture picture, IMapping? own, IShader model, Transform place) in things)
        {
            Material material = new()
            {
                Diffuse = Textured(picture, own), Specular = Intensity.Grey(0.4f), Shininess = 30, Reflection = Intensity.Grey(0.2f), Shader = Part(model, shader),
            };
            scene.Add(Part(part, shape), material, place);
        }

        return scene;
    }

    private static Texture Colors()
    {
        Texture texture = new(13, 7);
        for (int x = 0; x < 13; x++)
        {
            for (int y = 0; y < 7; y++)
            {
                texture.ColorMap[x, y] = new Intensity(x / 13f, y / 7f, (x + y) % 3 / 2f);
            }
        }

        return texture;
    }
}
