namespace LabRaytracer.Tests.Rendering;

/// <summary>The picture path takes no memory from the garbage collector once its lists have grown.</summary>
public sealed class AllocationTests
{
    private const int Side = 64;

    [Fact]
    public void Render_TexturedSphereOnFloor_AllocatesNothing() => Assert.Equal(0, AllocatedBytes(Floor(ball: Material.Matte(Colors()))));

    [Fact]
    public void Render_MirrorsAndGlass_AllocatesNothing()
    {
        Scene scene = Floor(new Material { Diffuse = Colors(), Reflection = Intensity.Grey(0.6f), Transparency = Intensity.Grey(0.3f), IndexOfRefraction = 1.5 });
        scene.Add(new Sphere(new Point3D(1.5, 0, -1)), new Material { Diffuse = Intensity.Black, Reflection = Intensity.White });
        Assert.Equal(0, AllocatedBytes(scene));
    }

    [Fact]
    public void Render_Mesh_AllocatesNothing()
    {
        Scene scene = Floor(Material.Matte(new CheckerTexture()));
        scene.Add(MeshSheet(20), Material.Matte(Colors()));
        Assert.Equal(0, AllocatedBytes(scene));
    }

    [Fact]
    public void Render_ManySpheres_AllocatesNothing()
    {
        Scene scene = Floor(Material.Matte(new GridTexture()));
        for (int i = 0; i < 100; i++)
        {
            scene.Add(new Sphere(new Point3D((i % 10) - 4.5, -0.6, (i / 10) - 4.5), 0.4), Material.Matte(Colors()));
        }

        Assert.Equal(0, AllocatedBytes(scene));
    }

    [Fact]
    public void Render_JitteredSamples_AllocatesNothing() =>
        Assert.Equal(0, AllocatedBytes(Floor(Material.Matte(Colors())), new RenderOptions { Width = Side, Height = Side, Samples = 4, Pattern = SamplePattern.Jittered }));

    /// <summary>Bytes that the second pass over the tiles takes; the first lets lists grow and compiles code.</summary>
    private static long AllocatedBytes(Scene scene, RenderOptions? options = null)
    {
        options ??= new RenderOptions { Width = Side, Height = Side };
        using CompiledScene<Double8, Float8, Int8> compiled = new(scene, null, 1);
        using TileWorker<Double8, Float8, Int8> worker = new(compiled, options, new PixelRectangle(0, 0, Side, Side));
        Picture picture = new(Side, Side);
        Pass(worker, picture);
        Pass(worker, picture);
        long before = GC.GetAllocatedBytesForCurrentThread();
        Pass(worker, picture);
        return GC.GetAllocatedBytesForCurrentThread() - before;
    }

    private static void Pass(TileWorker<Double8, Float8, Int8> worker, Picture picture)
    {
        for (int y = 0; y < Side; y += TileWorker<Double8, Float8, Int8>.Side)
        {
            for (int x = 0; x < Side; x += TileWorker<Double8, Float8, Int8>.Side)
            {
                worker.Render(x, y, picture, 0);
            }
        }
    }

    private static Scene Floor(Material ball)
    {
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0, 1, 5), Point3D.Origin, 50), Background = Colors() };
        scene.Add(new InfinitePlane(new Point3D(0, -1, 0), Vector3D.UnitY), Material.Matte(new CheckerTexture()));
        scene.Add(new Sphere(), ball);
        scene.Lights.Add(new AmbientLight(Intensity.Grey(0.2f)));
        scene.Lights.Add(new PointLight(new Point3D(4, 6, 5), Intensity.White));
        scene.Lights.Add(new DirectionalLight(new Vector3D(0.2, -1, -0.3), Intensity.Grey(0.4f)));
        return scene;
    }

    private static Texture Colors()
    {
        Texture texture = new(8, 4);
        for (int i = 0; i < 32; i++)
        {
            texture.ColorMap[i % 8, i / 8] = new Intensity(i / 32f, (i % 8) / 8f, 0.5f);
        }

        return texture;
    }

    private static TriangleMesh MeshSheet(int side)
    {
        List<Point3D> points = [];
        List<int> corners = [];
        for (int i = 0; i < (side + 1) * (side + 1); i++)
        {
            int column = i % (side + 1), row = i / (side + 1);
            points.Add(new Point3D((2.0 * column / side) - 1, 0.2 * Math.Sin(column), (2.0 * row / side) - 1));
            if (column < side && row < side)
            {
                corners.AddRange([i, i + side + 1, i + 1, i + 1, i + side + 1, i + side + 2]);
            }
        }

        return new TriangleMesh(points, corners.ToArray());
    }
}
