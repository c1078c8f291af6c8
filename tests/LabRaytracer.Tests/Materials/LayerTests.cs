using LabRaytracer.Tests.Rendering;

namespace LabRaytracer.Tests.Materials;

/// <summary>Stacks of textures over a coefficient, and decals.</summary>
public sealed class LayerTests
{
    [Theory]
    [InlineData(BlendMode.Replace, 1, 0.25f)]
    [InlineData(BlendMode.Replace, 0.5f, 0.5f)]
    [InlineData(BlendMode.Multiply, 1, 0.1875f)]
    [InlineData(BlendMode.Multiply, 0.5f, 0.46875f)]
    [InlineData(BlendMode.Add, 1, 1)]
    [InlineData(BlendMode.Add, 0.5f, 0.875f)]
    [InlineData(BlendMode.Mix, 1, 0.5f)]
    [InlineData(BlendMode.Mix, 0.5f, 0.625f)]
    public void Apply_Blend_IsTheFormula(BlendMode blend, float alpha, float expected)
    {
        // 0.75 below, 0.25 on top.
        TextureLayer layer = new(new ConstantTexture(Intensity.White)) { Blend = blend };
        Assert.Equal(Intensity.Grey(expected), layer.Apply(Intensity.Grey(0.75f), Intensity.Grey(0.25f), alpha));
        TextureLayer thin = new(layer.Texture) { Blend = blend, Opacity = alpha };
        Assert.Equal(Intensity.Grey(expected), thin.Apply(Intensity.Grey(0.75f), Intensity.Grey(0.25f), 1));
    }

    [Fact]
    public void Render_LayersOverAValue_AreStackedFromTheBottomUp()
    {
        // 1 under 0.5 at 1/2: 0.75; times 0.5: 0.375; blue untouched by the last, which is not there for u above 1/2.
        Texture half = new(new[,] { { Intensity.Black }, { Intensity.Black } }, new float[,] { { 1 }, { 0 } }) { Sampling = Nearest() };
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(new TextureSlot
        {
            Value = Intensity.White,
            Layers =
            [
                new TextureLayer(Flat(0.5f)) { Opacity = 0.5f },
                new TextureLayer(new ConstantTexture(Intensity.Grey(0.5f))) { Blend = BlendMode.Multiply },
                new TextureLayer(half),
            ],
        }));
        Picture picture = TestScenes.Render(scene, 8, 8);
        for (int x = 0; x < 8; x++)
        {
            Assert.Equal(Intensity.Grey(x < 4 ? 0 : 0.375f), picture[x, 3]);
        }
    }

    [Fact]
    public void Render_Decal_IsThereOnceAndTurned()
    {
        // A picture whose left half is black, half as wide and high as the quad, turned by 90 degrees: its left is below.
        Texture picture = new(new[,] { { Intensity.Black }, { new Intensity(0, 1, 0) } }) { Sampling = Nearest() };
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(new TextureSlot
        {
            Value = Intensity.White,
            Layers = [TextureLayer.Decal(picture, new TextureCoordinate(0.5, 0.25), new TextureCoordinate(0.5, 0.5), 90)],
        }));
        Picture result = TestScenes.Render(scene, 16, 16);
        for (int y = 0; y < 16; y++)
        {
            for (int x = 0; x < 16; x++)
            {
                bool inside = x is >= 4 and < 12 && y >= 8;
                Assert.Equal(inside ? new Intensity(0, y < 12 ? 1 : 0, 0) : Intensity.White, result[x, y]);
            }
        }
    }

    /// <summary>A picture, red on the left and green on the right, over the seam of u, as the uv view shows it; on the quad, which does not close, the half beyond its edge is lost.</summary>
    [Theory]
    [InlineData("sphere", true)]
    [InlineData("cylinder", true)]
    [InlineData("torus", true)]
    [InlineData("cone", true)]
    [InlineData("quad", false)]
    public void Render_DecalOverTheSeam_GoesOnAtItsOtherSide(string name, bool isClosed)
    {
        Shape shape = name switch
        {
            "sphere" => new Sphere(),
            "cylinder" => new Cylinder(),
            "torus" => new Torus(),
            "cone" => new Cone(),
            _ => new Quad(),
        };
        Texture picture = new(new[,] { { new Intensity(1, 0, 0) }, { new Intensity(0, 1, 0) } }) { Sampling = Nearest() };
        double middle = shape is Torus ? 0.2 : 0.5;
        Material material = TestScenes.Shining(new TextureSlot
        {
            Value = Intensity.White, Layers = [TextureLayer.Decal(picture, new TextureCoordinate(0, middle), new TextureCoordinate(0.1, 0.4))],
        });
        Scene scene = new() { Camera = shape is Quad ? TestScenes.AboveQuad() : new OrthographicCamera(new Point3D(0, 3, 9), Point3D.Origin, 3) };
        scene.Add(shape, material);
        Picture Show(RenderView view) => Renderer.Render(scene, new RenderOptions { Width = 120, Height = 120, View = view }).Picture;
        Picture result = Show(RenderView.Color), where = Show(RenderView.Uv), there = Show(RenderView.Object);
        int red = 0, green = 0;
        for (int y = 0; y < 120; y++)
        {
            for (int x = 0; x < 120; x++)
            {
                if (there[x, y] == Intensity.Black)
                {
                    continue;
                }

                (float u, float v) = (where[x, y].R, where[x, y].G);
                bool isHigh = Math.Abs(v - middle) < 0.2;
                Intensity expected = isHigh && isClosed && u > 0.95f ? new Intensity(1, 0, 0) : isHigh && u < 0.05f ? new Intensity(0, 1, 0) : Intensity.White;
                Assert.True(expected == result[x, y], $"({u}, {v}) shows {result[x, y]}");
                red += expected.G == 0 ? 1 : 0;
                green += expected.R == 0 ? 1 : 0;
            }
        }

        Assert.True(green > 20 && (red > 20) == isClosed, $"{red} red, {green} green");
    }

    /// <summary>Around the tube of a torus too: the picture lies over its outer equator, v = 0.</summary>
    [Fact]
    public void Render_DecalOverTheEquatorOfATorus_IsOnBothSides()
    {
        Material material = TestScenes.Shining(new TextureSlot
        {
            Value = Intensity.White, Layers = [TextureLayer.Decal(new ConstantTexture(Intensity.Black), new TextureCoordinate(1, 1), new TextureCoordinate(0.1, 0.2))],
        });
        Scene scene = new() { Camera = new OrthographicCamera(new Point3D(0, 0, 9), Point3D.Origin, 0.4) };
        scene.Add(new Torus(), material);
        Picture picture = TestScenes.Render(scene, 20, 20);
        Assert.Equal((Intensity.Black, Intensity.Black), (picture[9, 7], picture[10, 12]));
    }

    [Theory]
    [InlineData(0.1, 0.7, 0, 0)]
    [InlineData(0.5, 0.7, 1, 0)]
    [InlineData(0.1, 0.9, 0, 1)]
    public void Placing_CornersOfTheRectangle_BecomeTheUnitSquare(double u, double v, double expectedU, double expectedV)
    {
        TextureCoordinate at = UvTransform.Placing(new TextureCoordinate(0.3, 0.8), new TextureCoordinate(0.4, 0.2), 0).Apply(new TextureCoordinate(u, v));
        Assert.Equal(expectedU, at.U, 14);
        Assert.Equal(expectedV, at.V, 14);
    }

    [Theory]
    [InlineData(0, 1)]
    [InlineData(1, -1)]
    [InlineData(double.NaN, 1)]
    [InlineData(double.PositiveInfinity, 1)]
    [InlineData(1, 1e-320)]
    public void Placing_OddSizes_AreRefused(double width, double height) =>
        Assert.Throws<ArgumentException>(() => UvTransform.Placing(default, new TextureCoordinate(width, height), 0));

    [Fact]
    public void Edges_OfALayerOverItsOwnColor_StayThatColor()
    {
        Intensity[,] colors = new Intensity[3, 3];
        float[,] alpha = new float[3, 3];
        (colors[1, 1], alpha[1, 1]) = (Intensity.Grey(0.5f), 1);
        Scene scene = TestScenes.QuadFromAbove(TestScenes.Shining(new TextureSlot
        {
            Value = Intensity.Grey(0.5f), Layers = [new TextureLayer(new Texture(colors, alpha))],
        }));
        foreach (Intensity pixel in TestScenes.Render(scene, 29, 29).Pixels.ToArray())
        {
            Assert.InRange(pixel.G, 0.5f - 6e-8f, 0.5f + 6e-8f);
        }
    }

    [Fact]
    public void Inside_OfAShape_HasItsOwnMaterial()
    {
        Material page = new() { Diffuse = Intensity.Black, Emission = Intensity.White, Inside = TestScenes.Shining(new TextureSlot { Texture = Flat(0.25f) }) };
        Scene scene = TestScenes.QuadFromAbove(page);
        scene.Objects.Clear();
        scene.Add(new Quad(), page, Transform.Scaling(new Vector3D(1, 1, 0.5)).Then(Transform.Translation(new Vector3D(0, 0, -0.5))));
        scene.Add(new Quad(), page, Transform.Rotation(Vector3D.UnitX, 180).Then(Transform.Scaling(new Vector3D(1, 1, 0.5))).Then(Transform.Translation(new Vector3D(0, 0, 0.5))));
        Picture picture = TestScenes.Render(scene, 10, 10);
        for (int x = 0; x < 10; x++)
        {
            Assert.Equal(Intensity.Grey(x < 5 ? 1 : 0.25f), picture[x, 4]);
        }
    }

    [Theory]
    [InlineData(1, 0.125f)]
    [InlineData(0.5, 0.1875f)]
    [InlineData(0, 0.25f)]
    public void Occlusion_WeakensAmbientLightAlone(double amount, float expected)
    {
        // Ambient 0.5 on k_a 0.5, a lamp of 1 on k_d 0.5; the map says 1/2.
        ScalarSlot occlusion = new() { Value = 1, Texture = Flat(0.5f), Amount = (float)amount };
        Scene scene = TestScenes.QuadFromAbove(new Material { Diffuse = Intensity.Grey(0.5f), Occlusion = occlusion });
        scene.Lights.Add(new AmbientLight(Intensity.Grey(0.5f)));
        Assert.All(TestScenes.Render(scene, 4, 4).Pixels.ToArray(), pixel => Assert.Equal(expected, pixel.G));
        scene.Lights.Add(new DirectionalLight(-Vector3D.UnitY, Intensity.White));
        Assert.All(TestScenes.Render(scene, 4, 4).Pixels.ToArray(), pixel => Assert.Equal(expected + 0.5f, pixel.G));
    }

    [Theory]
    [InlineData(LightMapMode.Add, 0.75f, 16)]
    [InlineData(LightMapMode.Replace, 0.25f, 0)]
    public void LightMap_AddsToLampsOrReplacesThem(LightMapMode mode, float expected, int shadowRays)
    {
        Scene scene = TestScenes.QuadFromAbove(new Material { Diffuse = Intensity.Grey(0.5f), LightMap = Flat(0.5f), LightMapMode = mode });
        scene.Lights.Add(new DirectionalLight(-Vector3D.UnitY, Intensity.White));
        RenderResult result = Renderer.Render(scene, new RenderOptions { Width = 4, Height = 4 });
        Assert.All(result.Picture.Pixels.ToArray(), pixel => Assert.Equal(expected, pixel.G));
        Assert.Equal(shadowRays, result.Statistics.ShadowRays);
    }

    private static Texture Flat(float grey) => new(new[,] { { Intensity.Grey(grey) } });

    private static SamplingOptions Nearest() => new() { Filter = TextureFilter.Nearest };
}
