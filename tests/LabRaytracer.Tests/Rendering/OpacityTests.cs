namespace LabRaytracer.Tests.Rendering;

/// <summary>Surfaces of which only a share is there, or only parts: seen, seen through, and in shadows.</summary>
public sealed class OpacityTests
{
    private static readonly Intensity s_front = new(0.5f, 0.25f, 1), s_back = new(0.25f, 0.75f, 0.5f);

    [Theory]
    [InlineData(1, 0.5f, 0.25f, 1)]
    [InlineData(0.5, 0.375f, 0.5f, 0.75f)]
    [InlineData(0.25, 0.3125f, 0.625f, 0.625f)]
    [InlineData(0, 0.25f, 0.75f, 0.5f)]
    [InlineData(-3, 0.25f, 0.75f, 0.5f)]
    [InlineData(7, 0.5f, 0.25f, 1)]
    public void Opacity_Constant_IsTheShareOfTheFront(double opacity, float red, float green, float blue)
    {
        Scene scene = TestScenes.QuadFromAbove(new Material { Diffuse = Intensity.Black, Emission = s_front, Opacity = opacity });
        scene.Background = s_back;
        Assert.All(TestScenes.Render(scene, 8, 8).Pixels.ToArray(), pixel => Assert.Equal(new Intensity(red, green, blue), pixel));
    }

    [Fact]
    public void Opacity_TwoLayersOverAnother_AreWeightedFromTheFront()
    {
        // 1/2 of 1, 1/4 of 0.5, 1/4 of 0.25.
        var scene = new Scene { Camera = TestScenes.AboveQuad() };
        scene.Add(new Quad(), TestScenes.Shining(Intensity.Grey(0.25f)));
        scene.Add(new Quad(), Shining(Intensity.Grey(0.5f), 0.5), Transform.Translation(new Vector3D(0, 1, 0)));
        scene.Add(new Quad(), Shining(Intensity.White, 0.5), Transform.Translation(new Vector3D(0, 2, 0)));
        Assert.All(TestScenes.Render(scene, 8, 8).Pixels.ToArray(), pixel => Assert.Equal(Intensity.Grey(0.6875f), pixel));
    }

    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Single)]
    public void Opacity_AlphaZeroEverywhere_SameBitsAsWithoutTheObject(Precision precision)
    {
        RenderOptions options = new() { Width = 70, Height = 45, Threads = 1, Precision = precision };
        Scene scene = TestScenes.Everything();
        Picture without = Renderer.Render(scene, options).Picture;
        foreach (ScalarSlot opacity in new ScalarSlot[] { 0, new() { Value = 1, Texture = Alpha((_, _) => 0), Channel = TextureChannel.Alpha } })
        {
            Scene with = TestScenes.Everything();
            Material nothing = new() { Diffuse = Intensity.White, Reflection = Intensity.Grey(0.5f), Opacity = opacity };
            with.Add(new Sphere(new Point3D(0.5, 0.5, 1.5), 1.2), nothing);
            with.Add(new Quad(), nothing, Transform.Rotation(Vector3D.UnitX, 70).Then(Transform.Translation(new Vector3D(0, 1, 2.5))));
            PictureAssert.SameBits(without, Renderer.Render(with, options).Picture);
        }
    }

    [Theory]
    [InlineData(1, 0.5, 0.25f)]
    [InlineData(2, 0.5, 0.125f)]
    [InlineData(1, 0.25, 0.375f)]
    [InlineData(3, 1, 0)]
    public void Shadow_ThroughLayers_IsTheProductOfWhatTheyLetThrough(int layers, double opacity, float expected)
    {
        Scene scene = Floor();
        for (int layer = 0; layer < layers; layer++)
        {
            scene.Add(new Quad(), new Material { Opacity = opacity }, Transform.Scaling(new Vector3D(9, 1, 9)).Then(Transform.Translation(new Vector3D(0, 3 + layer, 0))));
        }

        Assert.All(TestScenes.Render(scene, 16, 16).Pixels.ToArray(), pixel => Assert.Equal(expected, pixel.G));
    }

    [Fact]
    public void Shadow_OfASphereWithOpacity_PassesFrontAndBack()
    {
        Scene scene = Floor();
        scene.Add(new Sphere(new Point3D(0, 3, 0)), new Material { Opacity = 0.5 });
        Picture picture = TestScenes.Render(scene, 64, 64);
        for (int row = 0; row < 64; row++)
        {
            for (int column = 0; column < 64; column++)
            {
                double z = (column + 0.5 - 32) / 16, x = (32 - row - 0.5) / 16;
                Assert.Equal(Math.Sqrt((x * x) + (z * z)) < 1 ? 0.125f : 0.5f, picture[column, row].R);
            }
        }
    }

    [Fact]
    public void Shadow_OfACutOut_IsTheCutOut()
    {
        // Opaque where x > 0, which is v > 1/2; an object that casts no shadow stays without one.
        Scene scene = Floor();
        Material half = new() { Opacity = new ScalarSlot { Value = 1, Channel = TextureChannel.Alpha, Texture = Alpha((_, y) => y) } };
        scene.Add(new Quad(), half, Transform.Scaling(new Vector3D(9, 1, 9)).Then(Transform.Translation(new Vector3D(0, 3, 0))));
        Picture picture = TestScenes.Render(scene, 16, 16);
        Assert.Equal(0, picture[3, 3].G);
        Assert.Equal(0.5f, picture[3, 12].G);
        scene.Objects[1] = new SceneObject(new Quad(), half, Transform.Translation(new Vector3D(0, 3, 0))) { CastsShadows = false };
        Assert.All(TestScenes.Render(scene, 16, 16).Pixels.ToArray(), pixel => Assert.Equal(0.5f, pixel.G));
    }

    [Fact]
    public void Edges_OfAWhiteCutOutOverWhite_StayWhite()
    {
        // Hidden texels are black: colours filtered without alpha would leave grey fringes.
        Intensity[,] colors = new Intensity[5, 5];
        float[,] alpha = new float[5, 5];
        (colors[2, 2], alpha[2, 2]) = (Intensity.White, 1);
        (colors[1, 3], alpha[1, 3]) = (Intensity.White, 1);
        Texture texture = new(colors, alpha);
        Scene scene = TestScenes.QuadFromAbove(new Material
        {
            Diffuse = Intensity.Black,
            Emission = texture,
            Opacity = new ScalarSlot { Value = 1, Texture = texture, Channel = TextureChannel.Alpha },
        });
        scene.Background = Intensity.White;
        foreach (Intensity pixel in TestScenes.Render(scene, 37, 37).Pixels.ToArray())
        {
            // Two roundings of a mean of ones.
            Assert.InRange(pixel.G, 1 - 2.5e-7f, 1 + 2.5e-7f);
        }
    }

    [Fact]
    public void Rays_EndAfter256Layers()
    {
        var scene = new Scene { Camera = TestScenes.AboveQuad(), Background = Intensity.White };
        Material window = Shining(Intensity.Black, 1e-9);
        void Stack(int count)
        {
            while (scene.Objects.Count < count)
            {
                scene.Add(new Quad(), window, Transform.Translation(new Vector3D(0, -scene.Objects.Count, 0)));
            }
        }

        Stack(256);
        Assert.Equal(Intensity.White, TestScenes.Render(scene, 1, 1)[0, 0]);
        Stack(257);
        Assert.Equal(Intensity.Black, TestScenes.Render(scene, 1, 1)[0, 0]);
    }

    [Theory]
    [InlineData(4)]
    [InlineData(8)]
    [InlineData(16)]
    public void Layers_AnyVectorWidthThreadsOrCrop_SameBits(int laneWidth)
    {
        Scene scene = Windows();
        RenderOptions options = new() { Width = 70, Height = 45, Threads = 1 };
        Picture narrow = Renderer.Render(scene, options, 1, null, default).Picture;
        PictureAssert.SameBits(narrow, Renderer.Render(scene, options, laneWidth, null, default).Picture);
        PictureAssert.SameBits(narrow, Renderer.Render(scene, new RenderOptions { Width = 70, Height = 45, Threads = 3 }).Picture);
        Picture part = Renderer.Render(scene, new RenderOptions { Width = 70, Height = 45, Crop = new PixelRectangle(13, 7, 40, 30) }).Picture;
        for (int y = 0; y < 30; y++)
        {
            Assert.True(part.Row(y).SequenceEqual(narrow.Row(7 + y).Slice(13, 40)), $"Row {y} differs.");
        }
    }

    [Fact]
    public void Opacity_OnlyWhereAMaterialHasOne_IsLookedAt()
    {
        Assert.Equal(0, Renderer.Render(TestScenes.Everything(), new RenderOptions { Width = 70, Height = 45 }).Statistics.AlphaTests);
        Assert.True(Renderer.Render(Windows(), new RenderOptions { Width = 70, Height = 45 }).Statistics.AlphaTests > 1000);
    }

    [Fact]
    public void Opacity_NotANumber_MakesThePixelsThatShowIt()
    {
        Scene scene = TestScenes.QuadFromAbove(Shining(Intensity.White, new ScalarSlot { Value = 1, Texture = new ConstantTexture(Intensity.Grey(float.NaN)) }));
        RenderStatistics statistics = Renderer.Render(scene, new RenderOptions { Width = 4, Height = 4 }).Statistics;
        Assert.Equal(16, statistics.NotFinitePixels);
    }

    private static Material Shining(Intensity color, ScalarSlot opacity) => new() { Diffuse = Intensity.Black, Emission = color, Opacity = opacity };

    /// <summary>A white picture of 2 x 2 texels with a given alpha.</summary>
    private static Texture Alpha(Func<int, int, float> alpha)
    {
        float[,] map = { { alpha(0, 0), alpha(0, 1) }, { alpha(1, 0), alpha(1, 1) } };
        Intensity[,] colors = { { Intensity.White, Intensity.White }, { Intensity.White, Intensity.White } };
        return new Texture(colors, map) { Sampling = new SamplingOptions { Filter = TextureFilter.Nearest } };
    }

    /// <summary>A floor of k_d 0.5 under a lamp of 1 straight above, seen from between floor and what casts shadows.</summary>
    private static Scene Floor()
    {
        var scene = new Scene { Camera = new OrthographicCamera(new Point3D(0, 1.5, 0), Point3D.Origin, 4, Vector3D.UnitX) };
        scene.Lights.Add(new DirectionalLight(-Vector3D.UnitY, Intensity.White));
        scene.Add(new InfinitePlane(), new Material { Diffuse = Intensity.Grey(0.5f) });
        return scene;
    }

    /// <summary>The scene with everything behind and between several things with opacities, some of which mirror.</summary>
    private static Scene Windows()
    {
        Scene scene = TestScenes.Everything();
        Texture leaf = Alpha((x, y) => x == y ? 1 : 0.3f).With(SamplingOptions.Default);
        Material window = new() { Diffuse = leaf, Reflection = Intensity.Grey(0.3f), Opacity = new ScalarSlot { Value = 1, Texture = leaf, Channel = TextureChannel.Alpha } };
        scene.Add(new Sphere(new Point3D(0.5, 0.5, 1.5), 0.6), window);
        scene.Add(new Sphere(new Point3D(-0.5, 0.5, 2), 0.5), new Material { Opacity = 0.4, Specular = Intensity.White });
        scene.Add(new Quad(), window, Transform.Rotation(Vector3D.UnitX, 70).Then(Transform.Translation(new Vector3D(0, 1, 2.5))));
        return scene;
    }
}
