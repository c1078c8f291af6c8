using LabRaytracer;

namespace RenderScene;

/// <summary>Figures 1 and 2: what textures are good for, and which coefficients they may drive.</summary>
internal static class MaterialFigures
{
    /// <summary>Figure 1: the same things without and with textures.</summary>
    public static Picture Advantages(FigureTools tools)
    {
        int width = (tools.Width - tools.Scaled(60)) / 2, height = tools.Scaled(460), margin = tools.Scaled(20);
        Canvas canvas = new(tools.Width, height + tools.Scaled(80), FigureTools.Paper);
        canvas.Paste(tools.Render(StillLife(isTextured: false), width, height), margin, margin);
        canvas.Paste(tools.Render(StillLife(isTextured: true), width, height), (2 * margin) + width, margin);
        canvas.Label("without textures", margin + (width / 2.0), height + tools.Scaled(58), tools.Scaled(18));
        canvas.Label("with textures", (2 * margin) + (1.5 * width), height + tools.Scaled(58), tools.Scaled(18));
        return canvas.Picture;
    }

    /// <summary>Figure 2: one texture of spots, each time on another coefficient of the material.</summary>
    public static Picture Slots(FigureTools tools)
    {
        Texture spots = Load("spots.png");
        TextureSlot slot = spots;
        ScalarSlot shininess = new() { Value = 150, Texture = spots, Amount = 0.96f };
        Intensity body = new(0.25f, 0.3f, 0.42f);
        (string Name, Material Material)[] slots =
        [
            ("diffuse", new Material { Diffuse = slot, Specular = Intensity.Grey(0.3f) }),
            ("ambient", new Material { Diffuse = body, Ambient = slot }),
            ("specular", new Material { Diffuse = body, Specular = slot, Shininess = 8 }),
            ("shininess", new Material { Diffuse = body, Specular = Intensity.Grey(0.8f), Shininess = shininess }),
            ("reflection", new Material { Diffuse = body, Reflection = slot }),
            ("transparency", new Material { Diffuse = body, Transparency = slot }),
            ("emission", new Material { Diffuse = body, Emission = slot }),
        ];
        int height = tools.Scaled(260);
        PerspectiveCamera camera = new(new Point3D(0, 2.2, 30), new Point3D(0, 0.06, 0), 7);
        Scene scene = FigureTools.Studio(camera);
        scene.Add(new InfinitePlane(new Point3D(0, -1, 0), Vector3D.UnitY), new Material { Diffuse = Intensity.Grey(0.6f) });
        Canvas canvas = new(tools.Width, height + tools.Scaled(60), FigureTools.Paper);
        for (int i = 0; i < slots.Length; i++)
        {
            scene.Add(new Sphere(new Point3D((i - 3) * 2.45, 0, 0), 1), slots[i].Material);
        }

        canvas.Paste(tools.Render(scene, tools.Width, height), 0, 0);
        for (int i = 0; i < slots.Length; i++)
        {
            canvas.Label(slots[i].Name, FigureTools.Project(camera, new Point3D((i - 3) * 2.45, -1, 1), tools.Width, height).X, height + tools.Scaled(36), tools.Scaled(14));
        }

        return canvas.Picture;
    }

    private static Scene StillLife(bool isTextured)
    {
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(-0.6, 1.5, 7.2), new Point3D(0, 0.35, 0), 34), Background = Intensity.Grey(0.6f) };
        scene.Lights.Add(new AmbientLight(Intensity.Grey(0.28f)));
        scene.Lights.Add(new PointLight(new Point3D(-4, 6, 5), new Intensity(0.8f, 0.76f, 0.7f)));
        scene.Lights.Add(new PointLight(new Point3D(5, 4, 6), new Intensity(0.14f, 0.16f, 0.2f)));
        TextureSlot Slot(Func<ITexture> texture, double scaleU = 1, double scaleV = 1) => isTextured
            ? new TextureSlot { Texture = texture(), Transform = new UvTransform(new(0, 0), 0, new(scaleU, scaleV), new(0, 0)) }
            : Intensity.Grey(0.5f);
        scene.Add(new InfinitePlane(new Point3D(0, -1, 0), Vector3D.UnitY), new Material { Diffuse = Slot(() => Load("wood.png"), 0.5, 0.5) });
        scene.Add(new Quad(new Point3D(-8, -1, -3), new Vector3D(0, 6, 0), new Vector3D(16, 0, 0)), new Material { Diffuse = Slot(() => Load("bricks.png"), 4, 3) });
        scene.Add(
            new Sphere(), new Material { Diffuse = Slot(() => Load("earth-2048x1024.png")), Specular = Intensity.Grey(0.25f), Shininess = 40 },
            Transform.Rotation(Vector3D.UnitY, 185).Then(Transform.Translation(new Vector3D(0.1, 0, 0.3))));
        scene.Add(
            new Box(), new Material { Diffuse = Slot(() => Load("crate.png")) },
            Transform.Scaling(new Vector3D(0.72, 0.72, 0.72)).Then(Transform.Rotation(Vector3D.UnitY, 28)).Then(Transform.Translation(new Vector3D(-2, -0.28, -0.4))));
        scene.Add(
            new Cylinder(new Point3D(2, -0.25, -0.2), 0.6, 1.5), new Material { Diffuse = Slot(() => new GridTexture { Columns = 16, Rows = 6 }) });
        scene.Add(new Disk(new Point3D(2, 0.5, -0.2), Vector3D.UnitY, 0.6), new Material { Diffuse = Intensity.Grey(0.5f) });
        return scene;
    }

    private static Texture Load(string name) => Texture.Load(SampleScenes.File(Path.Combine("textures", name)));
}
