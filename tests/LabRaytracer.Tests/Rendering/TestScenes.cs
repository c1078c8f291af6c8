namespace LabRaytracer.Tests.Rendering;

/// <summary>Scenes and short forms for tests of whole renders.</summary>
internal static class TestScenes
{
    /// <summary>A texture of random colours, repeatable.</summary>
    public static Texture Random(int width, int height, int seed = 1)
    {
        var random = new Random(seed);
        var colors = new Intensity[width, height];
        for (int x = 0; x < width; x++)
        {
            for (int y = 0; y < height; y++)
            {
                colors[x, y] = new Intensity(random.NextSingle(), random.NextSingle(), random.NextSingle());
            }
        }

        return new Texture(colors);
    }

    /// <summary>A surface that shows a texture as it is, whatever the light.</summary>
    public static Material Shining(TextureSlot emission) => new() { Diffuse = Intensity.Black, Emission = emission };

    /// <summary>
    /// A camera above the default quad whose picture, if square, is the quad exactly: u to the right, v up.
    /// </summary>
    public static OrthographicCamera AboveQuad(double y = 5) => new(new Point3D(0, y, 0), Point3D.Origin, 2, Vector3D.UnitX);

    /// <summary>The default quad with a material, seen exactly.</summary>
    public static Scene QuadFromAbove(Material material)
    {
        var scene = new Scene { Camera = AboveQuad() };
        scene.Add(new Quad(), material);
        return scene;
    }

    /// <summary>A bit of everything: textures in several slots, a mirror, glass, four kinds of lamps, a student's shape.</summary>
    public static Scene Everything()
    {
        var scene = new Scene
        {
            Camera = new PerspectiveCamera(new Point3D(0.3, 1.4, 5), new Point3D(0, 0.3, 0), 45),
            Background = new TextureSlot { Texture = Random(16, 8, 7), Value = new Intensity(0.2f, 0.3f, 0.5f) },
        };
        scene.Lights.Add(new AmbientLight(new Intensity(0.1f, 0.1f, 0.12f)));
        scene.Lights.Add(new PointLight(new Point3D(3, 4, 3), Intensity.Grey(0.6f)) { Attenuation = new Attenuation(1, 0.02, 0.01) });
        scene.Lights.Add(new DirectionalLight(new Vector3D(1, -2, -1), Intensity.Grey(0.3f)));
        scene.Lights.Add(new SpotLight(new Point3D(-3, 4, 2), Point3D.Origin, Intensity.Grey(0.5f), 30, 20));
        scene.Add(new InfinitePlane(new Point3D(0, -1, 0), Vector3D.UnitY), new Material { Diffuse = TextureSlot.Of(new CheckerTexture()), Reflection = Intensity.Grey(0.2f) });
        scene.Add(
            new Sphere(),
            new Material { Diffuse = Random(32, 16), Specular = Intensity.Grey(0.5f), Shininess = new ScalarSlot { Value = 60, Texture = Random(8, 4, 3) } },
            Transform.Rotation(new Vector3D(1, 2, 3), 40));
        scene.Add(new Sphere(new Point3D(2, -0.3, 0.5), 0.7), new Material { Diffuse = Intensity.Grey(0.05f), Reflection = new Intensity(0.8f, 0.7f, 0.5f) });
        scene.Add(
            new Sphere(new Point3D(-1.7, -0.4, 1), 0.6),
            new Material { Diffuse = Intensity.Black, Transparency = Intensity.Grey(0.9f), IndexOfRefraction = 1.5, Fresnel = FresnelModel.Dielectric });
        scene.Add(
            new Quad(),
            new Material { Diffuse = TextureSlot.Of(new GridTexture()), Shader = LambertShader.Default },
            Transform.Rotation(Vector3D.UnitX, 80).Then(Transform.Translation(new Vector3D(0, 0.5, -2))));
        return scene;
    }

    /// <summary>Renders with a few options.</summary>
    public static Picture Render(Scene scene, int width, int height, int threads = 1) =>
        Renderer.Render(scene, new RenderOptions { Width = width, Height = height, Threads = threads }).Picture;
}
