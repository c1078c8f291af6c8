namespace LabRaytracer.Tests.Rendering;

/// <summary>The sheet's errors and traps that show in whole pictures.</summary>
public sealed class ErrataTests
{
    [Theory]
    [InlineData(4, 4)]
    [InlineData(3, 9)]
    [InlineData(16, 2)]
    public void E9_PictureOfAnyAspect_CoversTheSphere_WithoutResampling(int width, int height)
    {
        // The sheet asks to rescale pictures that are not 2:1. Normalised (u, v) stretch any picture: every texel is there, none is mixed.
        Texture texture = TestScenes.Random(width, height).With(new SamplingOptions { Filter = TextureFilter.Nearest });
        Scene scene = new() { Camera = new SphericalCamera(Point3D.Origin) };
        scene.Add(new Sphere(), TestScenes.Shining(texture));
        Picture seen = TestScenes.Render(scene, 4 * width, 4 * height);
        for (int y = 0; y < seen.Height; y++)
        {
            for (int x = 0; x < seen.Width; x++)
            {
                Assert.Equal(texture.ColorMap[x / 4, height - 1 - (y / 4)], seen[x, y]);
            }
        }
    }

    [Theory]
    [InlineData(TextureWrap.Repeat, 1)]
    [InlineData(TextureWrap.Clamp, 0)]
    [InlineData(TextureWrap.Mirror, 0)]
    [InlineData(TextureWrap.Border, -1)]
    public void E12_PointsOutsideTheSquare_FollowTheWrap(TextureWrap wrap, int column)
    {
        // The sheet says nothing of points outside [-1, 1]: at z = -1.5 the rectangular u is -1/4.
        Texture texture = new Texture(new[,] { { Intensity.Grey(0.25f) }, { Intensity.Grey(0.5f) } })
            .With(new SamplingOptions { Filter = TextureFilter.Nearest, WrapU = wrap });
        Scene scene = new() { Camera = new OrthographicCamera(new Point3D(0, 5, -1.5), new Point3D(0, 0, -1.5), 0.1, Vector3D.UnitX) };
        scene.Add(new InfinitePlane(), TestScenes.Shining(texture));
        Assert.Equal(column < 0 ? Intensity.Black : texture.ColorMap[column, 0], TestScenes.Render(scene, 1, 1)[0, 0]);
    }

    [Fact]
    public void E14_SumsOfLights_AreNotClippedBeforeTheEnd()
    {
        Scene scene = TestScenes.QuadFromAbove(new Material());
        for (int light = 0; light < 3; light++)
        {
            scene.Lights.Add(new DirectionalLight(-Vector3D.UnitY, Intensity.Grey(0.75f)));
        }

        Assert.Equal(2.25f, TestScenes.Render(scene, 2, 2)[0, 0].R);
        Assert.Equal(new Intensity(-1, 2, 9), new Intensity(-1, 2, 9) * Intensity.White);
    }

    [Fact]
    public void E14_Highlight_IsNotTintedByTheTexture_NorMirroredBehindTheSurface()
    {
        // Light and viewer on the mirror axis: k_d T (N.L) + k_s exactly.
        Scene scene = TestScenes.QuadFromAbove(new Material { Diffuse = new Texture(new[,] { { new Intensity(1, 0, 0) } }), Specular = Intensity.Grey(0.5f), Shininess = 2 });
        scene.Lights.Add(new DirectionalLight(-Vector3D.UnitY, Intensity.White));
        Assert.Equal(new Intensity(1.5f, 0.5f, 0.5f), TestScenes.Render(scene, 1, 1)[0, 0]);

        // R.V below 0 with an even exponent: no highlight.
        SurfaceValues values = new(Intensity.Black, Intensity.White, 2);
        Vector3D toLight = new Vector3D(0.8, 0.6, 0), toViewer = new Vector3D(0.8, 0.6, 0);
        Assert.Equal(Intensity.Black, PhongShader.Default.Reflect(values, Vector3D.UnitY, toLight, toViewer));
    }
}
