namespace LabRaytracer.Tests.Rendering;

/// <summary>Pictures with a known answer, in the renderer's default mode: every 8-bit code is right, and floats are within a stated bound.</summary>
/// <remarks>Rows made by mpmath (Oracle/pictures.py).</remarks>
public sealed class AnalyticPictureTests
{
    /// <summary>Four roundings of colours to float.</summary>
    private const double Bound = 4.0 / (1 << 24);

    [Theory]
    [InlineData(12, 12, 0.47970161180012348, 184, 0.31983389451211421, 153)]
    [InlineData(15, 9, 0.69556762498932399, 217, 0.64268443801020512, 210)]
    [InlineData(16, 13, 0.50608248946535653, 189, 0.33739123093225368, 157)]
    [InlineData(12, 3, 0.56207609629466718, 198, 0.37471739752977812, 165)]
    [InlineData(7, 16, 0.0, 0, 0.0, 0)]
    [InlineData(18, 18, 0.074610827506798826, 77, 0.049740551671199217, 63)]
    [InlineData(16, 7, 0.74733313380584332, 224, 0.50071709265817613, 188)]
    [InlineData(14, 10, 0.63823711346423112, 209, 0.53148418448374159, 193)]
    [InlineData(5, 8, 0.17267598790518999, 115, 0.11511732527012666, 95)]
    public void LitSphere_MatteAndShiny_LightAndCodeAreRight(int column, int row, double matte, int matteCode, double shiny, int shinyCode)
    {
        Check(Ball(new Material { Diffuse = Intensity.Grey(0.75f) }), column, row, matte, matteCode);
        Check(Ball(new Material { Diffuse = Intensity.Grey(0.5f), Specular = Intensity.Grey(0.25f), Shininess = 20 }), column, row, shiny, shinyCode);
    }

    /// <summary>A plate of glass moves what lies behind it aside by a known way.</summary>
    [Theory]
    [InlineData(5, 1.5, 0.5182113527408678, 191)]
    [InlineData(5, 1.25, 0.51967292024006415, 191)]
    [InlineData(30, 1.5, 0.61636295747286244, 206)]
    [InlineData(30, 1.25, 0.62672325620770132, 207)]
    [InlineData(45, 1.5, 0.6918153104781061, 217)]
    [InlineData(45, 1.25, 0.71074929257125442, 219)]
    [InlineData(60, 1.5, 0.8048946985944281, 232)]
    [InlineData(60, 1.25, 0.83660246629992501, 236)]
    [InlineData(70, 1.5, 0.94389974995346615, 249)]
    [InlineData(70, 1.25, 0.98593249087211788, 253)]
    public void GlassPlate_FloorBehindIt_IsSeenWhereRefractionSays(double degrees, double index, double v, int code)
    {
        (double sin, double cos) = Math.SinCos(degrees * Math.PI / 180);
        var scene = new Scene { Camera = new OrthographicCamera(new Point3D(-5 * sin, 5 * cos, 0), Point3D.Origin, 0.1, Vector3D.UnitZ) };
        var glass = new Material { Diffuse = Intensity.Black, Transparency = Intensity.White, IndexOfRefraction = (float)index };
        scene.Add(new InfinitePlane(), glass);
        scene.Add(new InfinitePlane(new Point3D(0, -0.25, 0), -Vector3D.UnitY), glass);
        scene.Add(new InfinitePlane(new Point3D(0, -0.5, 0), Vector3D.UnitY), TestScenes.Shining(new TextureSlot { Texture = new HeightOnTexture(), Mapping = new RectangularMapping() }));
        Check(TestScenes.Render(scene, 1, 1), 0, 0, v, code);
    }

    /// <summary>Between two parallel mirrors of reflectance 3/4 a ray is reflected as often as its unfolded way crosses them: exactly (3/4)^n arrives.</summary>
    [Fact]
    public void TwoMirrors_RayThatLeavesAfterNReflections_BringsReflectanceToTheN()
    {
        const double Height = 19;
        Vector3D direction = new(0.9, 1, 0);
        var camera = new OrthographicCamera(Point3D.Origin - (direction * 3), Point3D.Origin, 0.8, Vector3D.UnitZ);
        var scene = new Scene { Camera = camera, Background = Intensity.White };
        var mirror = new Material { Diffuse = Intensity.Black, Reflection = Intensity.Grey(0.75f) };
        foreach (int side in new[] { -1, 1 })
        {
            scene.Add(new Quad(new Point3D(side, 0, -1), new Vector3D(0, Height, 0), new Vector3D(0, 0, 2)), mirror);
        }

        Picture picture = Renderer.Render(scene, new RenderOptions { Width = 40, Height = 40, MaxDepth = 12 }).Picture;
        HashSet<int> seen = [];
        for (int column = 0; column < 40; column++)
        {
            Ray ray = camera.RayAt(column + 0.5, 20, 40, 40);
            double end = ray.Origin.X + ((Height - ray.Origin.Y) / ray.Direction.Y * ray.Direction.X);
            int reflections = (int)Math.Floor((end + 1) / 2);
            float expected = (float)Math.Pow(0.75, reflections);
            seen.Add(reflections);
            for (int row = 0; row < 40; row++)
            {
                Assert.Equal(Intensity.Grey(expected), picture[column, row]);
            }
        }

        Assert.Equal([8, 9], seen.Order());
    }

    /// <summary>White things of every shape in white light from everywhere cannot be seen.</summary>
    [Fact]
    public void Furnace_EveryShapeAndTexture_IsExactlyWhite()
    {
        var scene = new Scene { Background = Intensity.White, Camera = new PerspectiveCamera(new Point3D(1, 3, 8), Point3D.Origin, 50) };
        scene.Lights.Add(new AmbientLight(Intensity.White));
        Texture white = new(3, 2);
        System.Runtime.InteropServices.MemoryMarshal.CreateSpan(ref white.ColorMap[0, 0], white.ColorMap.Length).Fill(Intensity.White);
        Material[] materials =
        [
            new Material(),
            new Material { Diffuse = white },
            new Material { Diffuse = TextureSlot.Of(new ConstantTexture(Intensity.White)), Shader = LambertShader.Default },
            new Material { Diffuse = Intensity.Black, Reflection = Intensity.White },
        ];
        Shape[] shapes =
        [
            new Sphere(), new Cylinder(), new Disk(), new Quad(), new Box(), new Triangle(Point3D.Origin, new Point3D(1, 0, 0), new Point3D(0, 1, 0)),
            new TriangleMesh([Point3D.Origin, new Point3D(1, 0, 0), new Point3D(0, 1, 0), new Point3D(0, 0, 1)], [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]),
        ];
        for (int i = 0; i < shapes.Length; i++)
        {
            scene.Add(shapes[i], materials[i % materials.Length], Transform.Rotation(new Vector3D(1, i, 2), 20 * i).Then(Transform.Translation(new Vector3D((1.4 * i) - 4, 0, -i))));
        }

        scene.Add(new InfinitePlane(new Point3D(0, -2, 0), Vector3D.UnitY), materials[1]);
        RenderResult result = Renderer.Render(scene, new RenderOptions { Width = 80, Height = 60 });
        Assert.InRange(result.Statistics.Hits, 3000, 10000);
        Assert.All(result.Picture.Pixels.ToArray(), pixel => Assert.Equal(Intensity.White, pixel));
    }

    private static Picture Ball(Material material)
    {
        var scene = new Scene { Camera = new OrthographicCamera(new Point3D(0, 0, 5), Point3D.Origin, 2.5) };
        scene.Add(new Sphere(), material);
        scene.Lights.Add(new PointLight(new Point3D(2, 3, 4), Intensity.White));
        return TestScenes.Render(scene, 25, 25);
    }

    /// <summary>One pixel as float and in a written PNG file.</summary>
    private static void Check(Picture picture, int column, int row, double light, int code)
    {
        Assert.InRange(picture[column, row].G, light - Bound, light + Bound);
        using TestFolder folder = new();
        picture.Save(folder["a.png"]);
        Assert.Equal(ColorEncoding.LinearFromSrgb8((byte)code), Picture.Load(folder["a.png"])[column, row].G);
    }

    /// <summary>v as grey.</summary>
    private sealed class HeightOnTexture : ITexture
    {
        public Intensity Sample(in TextureLookup lookup) => Intensity.Grey((float)lookup.Coordinate.V);
    }
}
