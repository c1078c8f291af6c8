namespace LabRaytracer.Tests.Rendering;

/// <summary>Footprints of samples are the differences of texture coordinates between neighbouring pixels, whatever lies between camera and texture.</summary>
public sealed class FootprintTests
{
    private const int Side = 4000, Window = 8;

    /// <summary>Neighbours are a few thousandths of an object apart: the second difference is that much of the first.</summary>
    private const double Tolerance = 0.01;

    private static readonly Transform s_skew =
        Transform.Scaling(new Vector3D(1, 0.6, 1.4)).Then(Transform.Rotation(new Vector3D(1, 2, 3), 40)).Then(Transform.Translation(new Vector3D(0.1, 0.2, -0.3)));

    public static TheoryData<string> Shapes => ["sphere", "cylinder", "quad", "disk", "box", "plane", "triangle", "mesh", "student"];

    [Theory]
    [MemberData(nameof(Shapes))]
    public void Footprint_ShapeSeenDirectly_IsTheDifferenceOfPixels(string name) => Check(Single(name, Transform.Identity, null));

    [Theory]
    [MemberData(nameof(Shapes))]
    public void Footprint_TransformedShape_IsTheDifferenceOfPixels(string name) => Check(Single(name, s_skew, null));

    [Theory]
    [MemberData(nameof(Shapes))]
    public void Footprint_StudentMappingOnShape_IsTheDifferenceOfPixels(string name) => Check(Single(name, s_skew, new Swirl()));

    /// <summary>A projector that stands in the world, whose gradient is one of the world point.</summary>
    [Theory]
    [MemberData(nameof(Shapes))]
    public void Footprint_ProjectorInTheWorld_IsTheDifferenceOfPixels(string name) =>
        Check(Single(name, s_skew, new ProjectorMapping(new Point3D(3, 4, 9), new Point3D(0, 0.2, 0), aspect: 1.5, frame: TextureFrame.World)));

    [Theory]
    [InlineData("sphere")]
    [InlineData("mesh")]
    [InlineData("student")]
    public void Footprint_StudentMappingInTheWorld_IsTheDifferenceOfPixels(string name) => Check(Single(name, s_skew, new WorldSwirl()));

    [Theory]
    [InlineData("sphere")]
    [InlineData("cylinder")]
    [InlineData("quad")]
    [InlineData("triangle")]
    [InlineData("mesh")]
    [InlineData("student")]
    public void Footprint_InMirror_IsTheDifferenceOfPixels(string name) =>
        Check(Through(name, new Material { Diffuse = Intensity.Black, Reflection = Intensity.White }, new Point3D(0, 3, 9)));

    [Theory]
    [InlineData("sphere")]
    [InlineData("box")]
    [InlineData("cylinder")]
    [InlineData("student")]
    public void Footprint_ThroughGlass_IsTheDifferenceOfPixels(string name) => Check(Through(
        name, new Material { Diffuse = Intensity.Black, Transparency = Intensity.White, IndexOfRefraction = 1.3 }, new Point3D(0, 0, -8)));

    [Theory]
    [InlineData("perspective")]
    [InlineData("orthographic")]
    [InlineData("spherical")]
    [InlineData("student")]
    public void Footprint_EveryCamera_IsTheDifferenceOfPixels(string name)
    {
        Scene scene = Single("sphere", s_skew, null);
        Point3D eye = new(0.5, 1.5, 6);
        scene.Camera = name switch
        {
            "orthographic" => new OrthographicCamera(eye, Point3D.Origin, 5),
            "spherical" => new SphericalCamera(new Point3D(0.1, 0.1, -0.2)),
            "student" => new StudentCamera(new PerspectiveCamera(eye, Point3D.Origin, 40)),
            _ => new PerspectiveCamera(eye, Point3D.Origin, 40),
        };
        Check(scene);
    }

    [Fact]
    public void Footprint_Background_IsTheDifferenceOfPixels() => Check(new Scene { Camera = new PerspectiveCamera(Point3D.Origin, new Point3D(1, 0.4, 0.3), 60) });

    [Fact]
    public void Footprint_UvTransform_ScalesAndTurnsIt() => Check(
        Single("quad", Transform.Identity, null), new UvTransform(new TextureCoordinate(3, 4), 30, new TextureCoordinate(5, -2), default));

    [Fact]
    public void LocalFootprint_TransformedSphere_IsTheDifferenceOfPixels() =>
        CheckSteps(TextureNeeds.LocalPoint, lookup => lookup.LocalPoint, lookup => lookup.LocalFootprint);

    [Fact]
    public void WorldFootprint_TransformedSphere_IsTheDifferenceOfPixels() =>
        CheckSteps(TextureNeeds.WorldPoint, lookup => lookup.WorldPoint, lookup => lookup.WorldFootprint);

    /// <summary>A sample covers a quarter of the world's unit, the noise has a thousand cells there: only the mean is left, however the object is scaled.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(1000)]
    public void NoiseFixedInTheWorld_FarBelowASample_IsItsMean(double scale)
    {
        var noise = new TransformedTexture(new NoiseTexture { Frequency = 1000 }) { Frame = TextureFrame.World };
        var scene = new Scene { Camera = TestScenes.AboveQuad() };
        scene.Add(new Quad(), TestScenes.Shining(TextureSlot.Of(noise)), Transform.Scaling(new Vector3D(scale, 1, scale)));
        Assert.All(TestScenes.Render(scene, 8, 8).Pixels.ToArray(), pixel => Assert.Equal(Intensity.Grey(0.5f), pixel));
    }

    private static void CheckSteps(TextureNeeds needs, Func<TextureLookup, Point3D> point, Func<TextureLookup, SurfaceFootprint> step)
    {
        Scene scene = Single("sphere", s_skew, null);
        Vector3D At(Picture[] pictures, int x, int y) => new(pictures[0][x, y].R, pictures[0][x, y].G, pictures[0][x, y].B);
        Picture[] points = [Render(scene, new Probe(lookup => Color(point(lookup).ToVector()), needs), null)];
        Picture[] right = [Render(scene, new Probe(lookup => Color(step(lookup).DpDx), needs | TextureNeeds.Footprint), null)];
        Picture[] down = [Render(scene, new Probe(lookup => Color(step(lookup).DpDy), needs | TextureNeeds.Footprint), null)];
        Vector3D across = (At(points, Window - 1, 3) - At(points, 0, 3)) / (Window - 1), below = (At(points, 3, Window - 1) - At(points, 3, 0)) / (Window - 1);
        Assert.InRange((At(right, Window / 2, 3) - across).Length, 0, Tolerance * across.Length);
        Assert.InRange((At(down, 3, Window / 2) - below).Length, 0, Tolerance * below.Length);
    }

    [Theory]
    [InlineData(4, 0.5)]
    [InlineData(16, 0.25)]
    public void Footprint_SeveralSamplesAPixel_IsDividedByTheRoot(int samples, double share)
    {
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(TextureSlot.Of(new Probe(Right, TextureNeeds.Coordinate | TextureNeeds.Footprint))));
        Picture picture = Renderer.Render(scene, new RenderOptions { Width = 10, Height = 10, Samples = samples }).Picture;
        Assert.Equal(0.1 * share, picture[5, 5].R, 1e-6);
    }

    private static void Check(Scene scene, UvTransform? transform = null)
    {
        Picture reference = Render(scene, new Probe(lookup => Color(new Vector3D(lookup.Coordinate.U, lookup.Coordinate.V, 0)), TextureNeeds.Coordinate), transform);
        Intensity middle = reference[Window / 2, Window / 2];
        Intensity Place(TextureLookup lookup) => Color(1000 * new Vector3D(lookup.Coordinate.U - middle.R, lookup.Coordinate.V - middle.G, 0));
        Picture place = Render(scene, new Probe(Place, TextureNeeds.Coordinate), transform);
        Picture right = Render(scene, new Probe(Right, TextureNeeds.Coordinate | TextureNeeds.Footprint), transform);
        Picture down = Render(scene, new Probe(Down, TextureNeeds.Coordinate | TextureNeeds.Footprint), transform);
        const int X = Window / 2, Y = Window / 2;
        Intensity expectedRight = (place[X + 1, Y] - place[X - 1, Y]) * 0.0005f, expectedDown = (place[X, Y + 1] - place[X, Y - 1]) * 0.0005f;
        float size = Math.Abs(expectedRight.R) + Math.Abs(expectedRight.G) + Math.Abs(expectedDown.R) + Math.Abs(expectedDown.G);
        Assert.InRange(size, 1e-5f, 1);
        Assert.Equal(expectedRight.R, right[X, Y].R, Tolerance * size);
        Assert.Equal(expectedRight.G, right[X, Y].G, Tolerance * size);
        Assert.Equal(expectedDown.R, down[X, Y].R, Tolerance * size);
        Assert.Equal(expectedDown.G, down[X, Y].G, Tolerance * size);
    }

    private static Intensity Right(TextureLookup lookup) => Color(new Vector3D(lookup.Footprint.DuDx, lookup.Footprint.DvDx, 0));

    private static Intensity Down(TextureLookup lookup) => Color(new Vector3D(lookup.Footprint.DuDy, lookup.Footprint.DvDy, 0));

    private static Intensity Color(Vector3D numbers) => new((float)numbers.X, (float)numbers.Y, (float)numbers.Z);

    private static Picture Render(Scene scene, Probe probe, UvTransform? transform)
    {
        TextureSlot slot = new() { Texture = probe, Transform = transform ?? UvTransform.Identity };
        Scene probed = new() { Camera = scene.Camera, Background = slot };
        foreach (SceneObject item in scene.Objects)
        {
            bool isProbed = item.Material.Name == "probed";
            probed.Add(item.Shape, isProbed ? TestScenes.Shining(WithMapping(slot, item.Material.Emission.Mapping)) : item.Material, item.Transform);
        }

        RenderOptions options = new() { Width = Side, Height = Side, Crop = new PixelRectangle((Side / 2) + 17, (Side / 2) - 40, Window, Window), Threads = 1 };
        return Renderer.Render(probed, options).Picture;
    }

    private static TextureSlot WithMapping(TextureSlot slot, IMapping? mapping) => new() { Texture = slot.Texture, Transform = slot.Transform, Mapping = mapping };

    private static Material Probed(IMapping? mapping) => new() { Name = "probed", Emission = new TextureSlot { Mapping = mapping } };

    private static Scene Single(string name, Transform transform, IMapping? mapping)
    {
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0.5, 1.5, 6), new Point3D(0, 0.1, 0), 40) };
        scene.Add(ShapeOf(name), Probed(mapping), transform);
        return scene;
    }

    /// <summary>A shape in front of the camera that shows a textured sphere from inside, far away.</summary>
    private static Scene Through(string name, Material material, Point3D middle)
    {
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0.5, 1.5, 6), new Point3D(0, 0.1, 0), 10) };
        scene.Add(ShapeOf(name), material, s_skew);
        scene.Add(new Sphere(middle, 15), Probed(null), Transform.Identity);
        return scene;
    }

    private static Shape ShapeOf(string name) => name switch
    {
        "sphere" => new Sphere(new Point3D(0.1, 0, 0.2), 1.5),
        "cylinder" => new Cylinder(new Point3D(0, 0, 0), 1.2, 4),
        "quad" => new Quad(new Point3D(-2, -2, 0.5), new Vector3D(0, 4, 0.5), new Vector3D(4, 1, 0)),
        "disk" => new Disk(new Point3D(0.5, 0.5, 0), new Vector3D(0.1, 0.2, 1), 2),
        "box" => new Box(new Point3D(-1.5, -1, -1), new Point3D(1.5, 1, 2)),
        "plane" => new InfinitePlane(new Point3D(0, -0.5, 0), new Vector3D(0.1, 1, 0.3)),
        "triangle" => new Triangle(new Point3D(-3, -2, 0), new Point3D(3, -2, 0.5), new Point3D(0, 4, 0))
        {
            VertexNormals = [new Vector3D(-0.3, -0.2, 1), new Vector3D(0.3, -0.2, 1), new Vector3D(0, 0.3, 1)],
            VertexCoordinates = [new TextureCoordinate(0.1, 0.2), new TextureCoordinate(0.9, 0.3), new TextureCoordinate(0.4, 1)],
        },
        "mesh" => new TriangleMesh(
            new double[] { -3, -2, 0, 3, -2, 0.5, 0, 4, 0, 9, 9, 9 }, [0, 1, 2, 1, 3, 2],
            new MeshOptions
            {
                Normals = new double[] { -0.3, -0.2, 1, 0.3, -0.2, 1, 0, 0.3, 1, 0, 0, 1 },
                TextureCoordinates = new double[] { 0.1, 0.2, 0.9, 0.3, 0.4, 1, 2, 2 },
            }),
        _ => new StudentShape(new Sphere(new Point3D(0.1, 0, 0.2), 1.5)),
    };

    /// <summary>A texture that shows what it is asked with.</summary>
    private sealed class Probe(Func<TextureLookup, Intensity> look, TextureNeeds needs) : ITexture
    {
        public TextureNeeds Needs => needs;

        public Intensity Sample(in TextureLookup lookup) => look(lookup);
    }

    /// <summary>A mapping that only knows its coordinates.</summary>
    private sealed class Swirl : IMapping
    {
        public TextureCoordinate Map(in SurfacePosition position)
        {
            (double x, double y, double z) = position.LocalPoint;
            return new TextureCoordinate((0.3 * x) + (0.1 * y * z), (0.2 * y) - (0.25 * z * x));
        }
    }

    /// <summary>The same in world space.</summary>
    private sealed class WorldSwirl : IMapping
    {
        public TextureFrame Frame => TextureFrame.World;

        public TextureCoordinate Map(in SurfacePosition position)
        {
            (double x, double y, double z) = position.WorldPoint;
            return new TextureCoordinate((0.3 * x) + (0.1 * y * z), (0.2 * y) - (0.25 * z * x));
        }
    }

    /// <summary>A shape that only knows one ray at a time.</summary>
    private sealed class StudentShape(Shape shape) : Shape
    {
        public override Bounds Bounds => shape.Bounds;

        public override IMapping DefaultMapping => shape.DefaultMapping;

        public override bool Intersect(in Ray ray, double limit, out Hit hit) => shape.Intersect(ray, limit, out hit);

        public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit) => shape.SurfaceAt(ray, hit);
    }

    /// <summary>A camera that only knows its rays.</summary>
    private sealed class StudentCamera(Camera camera) : Camera
    {
        public override Ray RayAt(double x, double y, int width, int height) => camera.RayAt(x, y, width, height);
    }
}
