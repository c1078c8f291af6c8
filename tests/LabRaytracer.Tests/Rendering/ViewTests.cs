namespace LabRaytracer.Tests.Rendering;

/// <summary>Views that show texels, cost and seams.</summary>
public sealed class ViewTests
{
    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Single)]
    public void Texel_QuadWithPicture_DiffersExactlyWhereNearestLookupDoes(Precision precision)
    {
        // A texture of distinct colours: two pixels have the same colour if and only if they read the same texel.
        Texture texture = TestScenes.Random(7, 5).With(new SamplingOptions { Filter = TextureFilter.Nearest });
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(texture));
        Picture Show(RenderView view) => Renderer.Render(scene, new RenderOptions { Width = 40, Height = 40, Precision = precision, View = view }).Picture;
        Intensity[] colors = Show(RenderView.Color).Pixels.ToArray(), texels = Show(RenderView.Texel).Pixels.ToArray();
        Dictionary<Intensity, Intensity> texelOfColor = [];
        for (int i = 0; i < colors.Length; i++)
        {
            Assert.True(texelOfColor.TryAdd(colors[i], texels[i]) || texelOfColor[colors[i]] == texels[i], $"pixel {i}");
        }

        Assert.Equal(7 * 5, texelOfColor.Count);
        Assert.Equal(7 * 5, texelOfColor.Values.Distinct().Count());
    }

    [Fact]
    public void Texel_Neighbours_DifferInEveryChannel()
    {
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(new Texture(16, 16)));
        Picture texels = Renderer.Render(scene, new RenderOptions { Width = 16, Height = 16, View = RenderView.Texel }).Picture;
        for (int y = 0; y < 16; y++)
        {
            for (int x = 1; x < 16; x++)
            {
                Assert.True(Farthest(texels[x, y], texels[x - 1, y]) >= 0.2f);
                Assert.True(Farthest(texels[y, x], texels[y, x - 1]) >= 0.2f);
            }
        }

        static float Farthest(Intensity a, Intensity b) => Math.Min(Math.Abs(a.R - b.R), Math.Min(Math.Abs(a.G - b.G), Math.Abs(a.B - b.B)));
    }

    /// <summary>Views take a surface with an opacity of a half and more for an opaque one, whether or not the scene's own textures are filtered.</summary>
    [Theory]
    [InlineData(RenderView.Uv)]
    [InlineData(RenderView.Normal)]
    [InlineData(RenderView.Depth)]
    [InlineData(RenderView.Texel)]
    [InlineData(RenderView.Seam)]
    [InlineData(RenderView.Mip)]
    [InlineData(RenderView.Stretch)]
    [InlineData(RenderView.Density)]
    public void View_SurfaceWithAnOpacity_IsSeenAsAnOpaqueOne(RenderView view)
    {
        foreach (TextureFilter filter in new[] { TextureFilter.Bilinear, TextureFilter.Trilinear })
        {
            Texture texture = TestScenes.Random(64, 32).With(SamplingOptions.Default.With(filter));
            Intensity[] Show(ScalarSlot opacity) => Renderer.Render(
                TestScenes.QuadFromAbove(new Material { Diffuse = texture, Opacity = opacity }), new RenderOptions { Width = 24, Height = 16, View = view }).Picture.Pixels.ToArray();
            Intensity[] opaque = Show(1);
            Assert.Equal(opaque, Show(0.75f));
            Assert.Equal(opaque, Show(new ScalarSlot { Value = 1, Texture = new ConstantTexture(Intensity.Grey(0.75f)) }));
        }
    }

    [Fact]
    public void Texel_WithoutPicture_IsGrey()
    {
        foreach (Material material in new[] { new Material(), new Material { Diffuse = TextureSlot.Of(new CheckerTexture()) } })
        {
            Picture picture = Renderer.Render(TestScenes.QuadFromAbove(material), new RenderOptions { Width = 3, Height = 3, View = RenderView.Texel }).Picture;
            Assert.All(picture.Pixels.ToArray(), pixel => Assert.Equal(Intensity.Grey(0.25f), pixel));
        }
    }

    [Fact]
    public void Texel_DiffuseAndOthers_ShowsDiffuse()
    {
        Picture Show(Material material) =>
            Renderer.Render(TestScenes.QuadFromAbove(material), new RenderOptions { Width = 20, Height = 20, View = RenderView.Texel }).Picture;
        Texture coarse = TestScenes.Random(2, 2), fine = TestScenes.Random(10, 10);
        Picture both = Show(new Material { Diffuse = coarse, Emission = fine }), one = Show(new Material { Diffuse = coarse });
        Assert.Equal(one.Pixels.ToArray(), both.Pixels.ToArray());
        Assert.Equal(4, both.Pixels.ToArray().Distinct().Count());
    }

    /// <summary>The quad fills the picture: texels over pixels, times the samples that share them.</summary>
    [Theory]
    [InlineData(40, 40, 1, 1, 1, 1)]
    [InlineData(80, 20, 1, 1, 1, 1)]
    [InlineData(80, 80, 1, 1, 1, 0)]
    [InlineData(80, 80, 4, 1, 1, 1)]
    [InlineData(160, 160, 1, 1, 0, 0)]
    [InlineData(80, 160, 1, 1, 0.5f, 0)]
    [InlineData(20, 20, 1, 0, 1, 1)]
    [InlineData(10, 10, 1, 0, 0, 1)]
    [InlineData(1, 1, 1, 0, 0, 0.25f)]
    [InlineData(640, 640, 1, 0.25f, 0, 0)]
    public void Density_QuadWithPicture_IsTexelsASample(int width, int height, int samples, float red, float green, float blue)
    {
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(new Texture(width, height)));
        Picture density = Renderer.Render(scene, new RenderOptions { Width = 40, Height = 40, Samples = samples, View = RenderView.Density }).Picture;
        Assert.All(density.Pixels.ToArray(), pixel =>
        {
            Assert.Equal(red, pixel.R, 1e-5);
            Assert.Equal(green, pixel.G, 1e-5);
            Assert.Equal(blue, pixel.B, 1e-5);
        });
    }

    [Theory]
    [InlineData(0f, 1, 1)]
    [InlineData(0f, 2, 2)]
    [InlineData(0.5f, 1, 2)]
    [InlineData(0.5f, 2, 3)]
    public void Cost_Quad_CountsCameraMirrorAndShadowRays(float mirror, int lamps, int rays)
    {
        Scene scene = TestScenes.QuadFromAbove(new Material { Reflection = Intensity.Grey(mirror) });
        for (int lamp = 1; lamp < lamps; lamp++)
        {
            scene.Lights.Add(new PointLight(new Point3D(0, 3, 0), Intensity.White));
        }

        RenderOptions options = new() { Width = 5, Height = 5, Samples = 4, View = RenderView.Cost };
        Assert.All(Renderer.Render(scene, options).Picture.Pixels.ToArray(), pixel => Assert.Equal(rays, Rays(pixel), 1e-5));
    }

    [Fact]
    public void Cost_Everything_AddsUpToTheStatistics()
    {
        RenderResult result = Renderer.Render(TestScenes.Everything(), new RenderOptions { Width = 70, Height = 45, View = RenderView.Cost });
        double sum = result.Picture.Pixels.ToArray().Sum(pixel => Math.Round(Rays(pixel)));
        Assert.Equal(result.Statistics.PrimaryRays + result.Statistics.SecondaryRays + result.Statistics.ShadowRays, sum);
        Assert.True(result.Statistics.SecondaryRays > 0 && result.Statistics.ShadowRays > 0);
    }

    [Fact]
    public void Seam_SpheresFromTheSideOfTheSeam_IsMarkedWhereNeighboursJump()
    {
        // The seam of the sheet's spherical mapping lies in the half plane x = 0, z > 0; three tiles by two.
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0.3, 1, 5), Point3D.Origin, 40) };
        scene.Add(new Sphere(), new Material());
        scene.Add(new Sphere(new Point3D(0.8, 0.2, 1), 0.4), new Material());
        Picture Show(RenderView view) => Renderer.Render(scene, new RenderOptions { Width = 90, Height = 60, View = view }).Picture;
        Picture seam = Show(RenderView.Seam), uv = Show(RenderView.Uv), objects = Show(RenderView.Object);
        bool Jumps(int x, int y, int otherX, int otherY) =>
            objects[x, y] == objects[otherX, otherY] && objects[x, y] != Intensity.Black && Math.Abs(uv[x, y].R - uv[otherX, otherY].R) > 0.5f;
        int marked = 0;
        for (int y = 1; y < 59; y++)
        {
            for (int x = 1; x < 89; x++)
            {
                bool isSeam = Jumps(x, y, x + 1, y) || Jumps(x, y, x - 1, y) || Jumps(x, y, x, y + 1) || Jumps(x, y, x, y - 1);
                Assert.True(isSeam == (seam[x, y] == new Intensity(1, 0, 0)), $"({x}, {y})");
                marked += isSeam ? 1 : 0;
            }
        }

        Assert.InRange(marked, 30, 200);
    }

    [Fact]
    public void Seam_Crop_IsThatPartOfTheWhole()
    {
        Scene scene = TestScenes.Everything();
        Picture whole = Renderer.Render(scene, new RenderOptions { Width = 80, Height = 60, View = RenderView.Seam }).Picture;
        Picture part = Renderer.Render(scene, new RenderOptions { Width = 80, Height = 60, View = RenderView.Seam, Crop = new PixelRectangle(21, 13, 40, 35) }).Picture;
        for (int y = 0; y < 35; y++)
        {
            Assert.Equal(whole.Row(y + 13).Slice(21, 40).ToArray(), part.Row(y).ToArray());
        }
    }

    [Theory]
    [InlineData(RenderView.Texel)]
    [InlineData(RenderView.Cost)]
    [InlineData(RenderView.Seam)]
    [InlineData(RenderView.Density)]
    public void View_AnyVectorWidthAndThreads_IsTheSamePicture(RenderView view)
    {
        Scene scene = TestScenes.Everything();
        RenderOptions options = new() { Width = 70, Height = 45, View = view, Threads = 1 }, parallel = new() { Width = 70, Height = 45, View = view, Threads = 3 };
        Intensity[] narrow = Renderer.Render(scene, options, 1, null, CancellationToken.None).Picture.Pixels.ToArray();
        Assert.Equal(narrow, Renderer.Render(scene, parallel).Picture.Pixels.ToArray());
    }

    /// <summary>Number of rays that a colour of the cost view stands for: a quarter of the scale is two doublings.</summary>
    private static double Rays(Intensity color)
    {
        double quarters = color.G > 0 ? (color.B > 0 ? 3 + color.B : 2 + color.G) : color.R > 0 ? 1 + color.R : color.B;
        double doublings = 2 * quarters, whole = Math.Floor(doublings + 1e-6);
        return Math.Pow(2, whole) * (1 + doublings - whole);
    }
}
