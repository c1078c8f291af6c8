namespace LabRaytracer.Tests.Rendering;

/// <summary>Heights and normal maps tilt normals as the geometry says: on any shape, transformed, mirrored, from both sides.</summary>
public sealed class ReliefTests
{
    private const int Side = 24;

    // Normals pass through colours: (n + 1) / 2 in float.
    private const float Tolerance = 4e-7f;

    [Fact]
    public void Bump_LinearRampPicture_IsTheTiltedPlane()
    {
        // h = 0.4 u and u = (z + 1) / 2: the slope along z is 0.2. Texels at the edge see the clamped picture beyond it.
        var ramp = new Intensity[64, 1];
        for (int x = 0; x < 64; x++)
        {
            ramp[x, 0] = Intensity.Grey((x + 0.5f) / 64);
        }

        Texture texture = new(ramp) { Sampling = new SamplingOptions { WrapU = TextureWrap.Clamp } };
        Picture normals = Normals(TestScenes.QuadFromAbove(Bumped(0.4, texture)), 64);
        for (int x = 1; x < 63; x++)
        {
            Same(Unit(0, 1, -0.2), normals[x, 20]);
        }
    }

    [Theory]
    [InlineData(1, 1, 1, -0.2)]
    [InlineData(3, 1, 1, -0.6)]
    [InlineData(-1, 1, 1, 0.2)]
    [InlineData(1, 5, 5, -0.04)]
    [InlineData(1, 2, 0.5, -0.4)]
    public void Bump_Ramp_IsInSceneUnits(double scaleU, double scaleX, double scaleZ, double slope)
    {
        // The texture is seen scaleU times; the quad is stretched: what counts is the relief that results.
        ScalarSlot bump = new() { Value = 0.4f, Texture = new Heights(u => (float)u.U), Transform = Scaled(scaleU, 1) };
        Scene scene = new() { Camera = TestScenes.AboveQuad() };
        scene.Add(new Quad(), new Material { Bump = bump }, Transform.Scaling(new Vector3D(scaleX, 3, scaleZ)));
        foreach (Intensity pixel in Seen(Normals(scene, Side)))
        {
            // Heights up to 3 are floats 2^-22 apart: over a step of 2^-11 to both sides that is 1.5e-4 of slope.
            Same(Unit(0, 1, slope), pixel, 7.5e-5f);
        }
    }

    [Fact]
    public void Bump_FromBelow_IsTheSameSurface()
    {
        Scene scene = TestScenes.QuadFromAbove(Bumped(0.4, new Heights(u => (float)u.U)));
        scene.Camera = new OrthographicCamera(new Point3D(0, -5, 0), Point3D.Origin, 1.9, Vector3D.UnitX);
        foreach (Intensity pixel in Normals(scene, Side).Pixels.ToArray())
        {
            Same(Unit(0, -1, 0.2), pixel, 5e-5f);
        }
    }

    [Theory]
    [InlineData(1, 0, 0, 0)]
    [InlineData(2, 0.3, -0.2, 0.1)]
    public void Bump_HeightAlongTheAxisOfASphere_IsItsGradient(double radius, double cx, double cy, double cz)
    {
        // h = 0.3 y of the unit sphere: grad h = 0.3 / r (e_y - n n_y).
        Scene scene = new() { Camera = new OrthographicCamera(new Point3D(cx, cy, 9), new Point3D(cx, cy, 0), 1.2 * radius) };
        scene.Add(new Sphere(new Point3D(cx, cy, cz), radius), Bumped(0.3, new Heights(null, p => (float)p.Y)));
        Picture bumped = Normals(scene, Side);
        scene.Objects[0] = new SceneObject(new Sphere(new Point3D(cx, cy, cz), radius), new Material());
        Picture smooth = Normals(scene, Side);
        for (int i = 0; i < bumped.Pixels.Length; i++)
        {
            Vector3D n = Decode(smooth.Pixels[i]);
            Vector3D expected = (n - ((Vector3D.UnitY - (n * n.Y)) * (0.3 / radius))).Normalized();
            Same(expected, bumped.Pixels[i], 4e-5f);
        }
    }

    [Fact]
    public void Bump_HeightInWorldSpace_DoesNotMoveWithTheObject()
    {
        // h = 0.2 Z of the world on a quad that is turned and stretched.
        Scene scene = new() { Camera = TestScenes.AboveQuad() };
        scene.Add(
            new Quad(),
            new Material { Bump = new ScalarSlot { Value = 0.2f, Texture = new WorldHeights() } },
            Transform.Scaling(new Vector3D(5, 2, 3)).Then(Transform.Rotation(Vector3D.UnitY, 30)));
        foreach (Intensity pixel in Seen(Normals(scene, Side)))
        {
            Same(Unit(0, 1, -0.2), pixel, 5e-5f);
        }
    }

    [Fact]
    public void Bump_HeightByLatitude_TiltsAlongTheMeridian()
    {
        // h = 0.5 v, v = 1 - theta / pi: grad h = 0.5 / (pi r) north, whatever the longitude.
        const double Radius = 1.5;
        Scene scene = new() { Camera = new OrthographicCamera(new Point3D(0, 0, 9), Point3D.Origin, 2) };
        scene.Add(new Sphere(Point3D.Origin, Radius), Bumped(0.5, new Heights(u => (float)u.V)));
        Picture bumped = Normals(scene, Side);
        scene.Objects[0] = new SceneObject(new Sphere(Point3D.Origin, Radius), new Material());
        Picture smooth = Normals(scene, Side);
        for (int i = 0; i < bumped.Pixels.Length; i++)
        {
            Vector3D n = Decode(smooth.Pixels[i]);
            Vector3D north = (Vector3D.UnitY - (n * n.Y)).Normalized();
            Same((n - (north * (0.5 / (Math.PI * Radius)))).Normalized(), bumped.Pixels[i], 4e-5f);
        }
    }

    [Theory]
    [InlineData(0.6, 0, 0.8, 1, 1, 0, 0.8, 0.6)]
    [InlineData(0, 0.6, 0.8, 1, 1, 0.6, 0.8, 0)]
    [InlineData(0.6, 0, 0.8, -1, 1, 0, 0.8, -0.6)]
    [InlineData(0, 0.6, 0.8, -1, 1, 0.6, 0.8, 0)]
    [InlineData(0, 0.6, 0.8, 1, -1, -0.6, 0.8, 0)]
    [InlineData(0.6, 0, 0.8, 1, -1, 0, 0.8, 0.6)]
    public void NormalMap_Constant_IsInTheTangentsOfTheMapping(double x, double y, double z, double scaleU, double scaleV, double nx, double ny, double nz)
    {
        // u grows along z, v along x; mirrored coordinates mirror the tangents.
        NormalMap map = new(Flat(x, y, z)) { Transform = Scaled(scaleU, scaleV) };
        foreach (Intensity pixel in Seen(Normals(TestScenes.QuadFromAbove(new Material { NormalMap = map }), Side)))
        {
            Same(new Vector3D(nx, ny, nz), pixel);
        }
    }

    [Fact]
    public void NormalMap_Options_AreTheFormulas()
    {
        Check(new NormalMap(Flat(0, 0.6, 0.8)) { FlipGreen = true }, new Vector3D(-0.6, 0.8, 0));
        Check(new NormalMap(Flat(0, 0.6, 0.8)) { Strength = 0.5f }, new Vector3D(0.3, 0.8, 0).Normalized());
        Check(new NormalMap(Flat(0, 0.6, 0)) { RebuildZ = true }, new Vector3D(0.6, 0.8, 0));
        Check(new NormalMap(Flat(0, 0.6, 0.8)) { Strength = 0 }, Vector3D.UnitY);
        Check(new NormalMap(Flat(0, 0.6, 0.8)) { Transform = new UvTransform(default, 90, new TextureCoordinate(1, 1), default) }, new Vector3D(0, 0.8, 0.6));
    }

    [Fact]
    public void NormalMap_StretchedQuad_HasTheSameTangents()
    {
        Scene scene = new() { Camera = TestScenes.AboveQuad() };
        scene.Add(
            new Quad(),
            new Material { NormalMap = new NormalMap(Flat(0.6, 0, 0.8)) },
            Transform.Scaling(new Vector3D(5, 2, 0.5)).Then(Transform.Rotation(Vector3D.UnitY, 90)));
        foreach (Intensity pixel in Seen(Normals(scene, Side)))
        {
            // Object z points along world x after the turn.
            Same(new Vector3D(0.6, 0.8, 0), pixel);
        }
    }

    [Fact]
    public void NormalMap_MirroredTriangle_HasMirroredTangents()
    {
        foreach (double sign in new double[] { 1, -1 })
        {
            Scene scene = TestScenes.QuadFromAbove(new Material());
            TextureCoordinate[] uvs = [new(0, 0), new(0, 9), new(9 * sign, 0)];
            scene.Objects[0] = new SceneObject(
                new Triangle(new Point3D(-4, 0, -4), new Point3D(-4, 0, 9), new Point3D(9, 0, -4)) { VertexCoordinates = uvs },
                new Material { NormalMap = new NormalMap(Flat(0.6, 0, 0.8)) });
            foreach (Intensity pixel in Seen(Normals(scene, Side)))
            {
                // u grows (or falls) along x.
                Same(new Vector3D(0.6 * sign, 0.8, 0), pixel);
            }
        }
    }

    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Single)]
    public void Relief_OfNoTilt_ChangesNoBit(Precision precision)
    {
        RenderOptions options = new() { Width = 70, Height = 45, Precision = precision };
        Scene flat = TestScenes.Everything(), same = TestScenes.Everything();
        for (int i = 0; i < flat.Objects.Count; i++)
        {
            SceneObject old = flat.Objects[i];
            Material m = old.Material;
            same.Objects[i] = new SceneObject(old.Shape, new Material
            {
                Diffuse = m.Diffuse, Specular = m.Specular, Shininess = m.Shininess, Reflection = m.Reflection, Transparency = m.Transparency,
                IndexOfRefraction = m.IndexOfRefraction, Fresnel = m.Fresnel, Shader = m.Shader, Bump = new ScalarSlot { Value = 2, Texture = new Texture(3, 3) },
                NormalMap = new NormalMap(new Texture(new[,] { { new Intensity(0.5f, 0.5f, 1) } })),
            }, old.Transform);
        }

        PictureAssert.SameBits(Renderer.Render(flat, options).Picture, Renderer.Render(same, options).Picture);
    }

    [Fact]
    public void Normals_OfASteepRelief_NeverFaceAwayFromTheViewer()
    {
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0, 0.4, 3), Point3D.Origin, 40) };
        scene.Add(new InfinitePlane(new Point3D(0, -0.3, 0), Vector3D.UnitY), new Material { NormalMap = new NormalMap(TestScenes.Random(16, 16)) { Strength = 20 } });
        scene.Add(new Sphere(), Bumped(30, TestScenes.Random(16, 16)));
        Picture normals = Normals(scene, 64);
        for (int y = 0; y < 64; y++)
        {
            for (int x = 0; x < 64; x++)
            {
                Vector3D n = Decode(normals[x, y]), view = -scene.Camera.RayAt(x + 0.5, y + 0.5, 64, 64).Direction;
                Assert.True(normals[x, y] == Intensity.Black || Vector3D.Dot(n, view) > -1e-6, $"({x}, {y}): {Vector3D.Dot(n, view)}");
            }
        }
    }

    [Theory]
    [InlineData(4)]
    [InlineData(8)]
    [InlineData(16)]
    public void Relief_AnyVectorWidth_SameBits(int laneWidth)
    {
        Scene scene = TestScenes.Everything();
        scene.Objects[1] = new SceneObject(
            new Sphere(),
            new Material { Specular = Intensity.White, Bump = new ScalarSlot { Value = 0.1f, Texture = TestScenes.Random(32, 16) } },
            Transform.Scaling(new Vector3D(1, 0.7, 1.1)).Then(Transform.Rotation(new Vector3D(1, 2, 3), 40)));
        scene.Objects[0] = new SceneObject(
            scene.Objects[0].Shape, new Material { Reflection = Intensity.Grey(0.3f), NormalMap = new NormalMap(TestScenes.Random(8, 8)), Bump = new() { Value = 0.02f, Texture = new Heights(null, p => (float)(p.X * p.Z)) } });
        RenderOptions options = new() { Width = 70, Height = 45, Threads = 1 };
        PictureAssert.SameBits(
            Renderer.Render(scene, options, 1, null, default).Picture, Renderer.Render(scene, options, laneWidth, null, default).Picture);
    }

    private static void Check(NormalMap map, Vector3D expected)
    {
        foreach (Intensity pixel in Seen(Normals(TestScenes.QuadFromAbove(new Material { NormalMap = map }), 4)))
        {
            Same(expected, pixel);
        }
    }

    private static Material Bumped(double height, ITexture heights) => new() { Bump = new ScalarSlot { Value = (float)height, Texture = heights } };

    private static UvTransform Scaled(double u, double v) => new(default, 0, new TextureCoordinate(u, v), default);

    /// <summary>A map of one normal.</summary>
    private static Texture Flat(double x, double y, double z) => new(new[,] { { new Intensity((float)((x + 1) / 2), (float)((y + 1) / 2), (float)((z + 1) / 2)) } });

    private static Picture Normals(Scene scene, int side) =>
        Renderer.Render(scene, new RenderOptions { Width = side, Height = side, View = RenderView.Normal, Threads = 1 }).Picture;

    /// <summary>Pixels that show a surface.</summary>
    private static IEnumerable<Intensity> Seen(Picture picture)
    {
        Intensity[] pixels = [.. picture.Pixels.ToArray().Where(pixel => pixel != Intensity.Black)];
        Assert.NotEmpty(pixels);
        return pixels;
    }

    private static Vector3D Unit(double x, double y, double z) => new Vector3D(x, y, z).Normalized();

    private static Vector3D Decode(Intensity pixel) => new((2.0 * pixel.R) - 1, (2.0 * pixel.G) - 1, (2.0 * pixel.B) - 1);

    private static void Same(Vector3D expected, Intensity pixel, float tolerance = Tolerance)
    {
        Vector3D actual = Decode(pixel);
        Assert.True((actual - expected).Length < 2 * tolerance, $"expected {expected}, got {actual}");
    }

    /// <summary>Heights that grow along Z of the world.</summary>
    private sealed class WorldHeights : ITexture
    {
        public TextureNeeds Needs => TextureNeeds.WorldPoint;

        public Intensity Sample(in TextureLookup lookup) => Intensity.Grey((float)lookup.WorldPoint.Z);
    }

    /// <summary>Heights by a formula of (u, v) or of the local point.</summary>
    private sealed class Heights(Func<TextureCoordinate, float>? byCoordinate, Func<Point3D, float>? byPoint = null) : ITexture
    {
        public TextureNeeds Needs => byPoint is null ? TextureNeeds.Coordinate : TextureNeeds.LocalPoint;

        public Intensity Sample(in TextureLookup lookup) => Intensity.Grey(byPoint is null ? byCoordinate!(lookup.Coordinate) : byPoint(lookup.LocalPoint));
    }
}
