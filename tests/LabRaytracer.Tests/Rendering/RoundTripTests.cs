namespace LabRaytracer.Tests.Rendering;

/// <summary>
/// A panorama camera in the middle of a textured sphere gives the sphere's picture back, texel by texel: mapping, orientation, seam, poles and lookup in one.
/// </summary>
public sealed class RoundTripTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(2, 1)]
    [InlineData(7, 3)]
    [InlineData(10, 10)]
    [InlineData(33, 65)]
    [InlineData(64, 32)]
    [InlineData(255, 127)]
    [InlineData(512, 256)]
    public void SphericalCamera_InsideATexturedSphere_GivesThePictureBack(int width, int height) =>
        Check(width, height, new Sphere(), Point3D.Origin, Precision.Double, LaneWidth.Best);

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(8)]
    [InlineData(16)]
    public void SphericalCamera_AnyVectorWidth_GivesThePictureBack(int laneWidth)
    {
        Check(61, 29, new Sphere(), Point3D.Origin, Precision.Double, laneWidth);
        Check(61, 29, new Sphere(), Point3D.Origin, Precision.Single, laneWidth);
    }

    [Theory]
    [InlineData(1e-3)]
    [InlineData(1.5)]
    [InlineData(1e6)]
    public void SphericalCamera_AnyRadiusAndCentre_GivesThePictureBack(double radius)
    {
        var centre = new Point3D(3 * radius, -2 * radius, 0.7 * radius);
        Check(128, 64, new Sphere(centre, radius), centre, Precision.Double, LaneWidth.Best);
    }

    [Fact]
    public void SphericalCamera_LabLinear_NodesComeBack()
    {
        // The sheet's reals x_p = (W - 1) u: between nodes, half of each neighbour.
        Texture texture = new Texture(new[,] { { Intensity.Grey(0) }, { Intensity.Grey(1) }, { Intensity.Grey(2) } })
            .With(new SamplingOptions { Texels = TexelConvention.Lab, WrapU = TextureWrap.Clamp });
        Assert.Equal(Intensity.Grey(0.5f), texture.Sample(TextureLookup.At(0.25, 0)));
        Assert.Equal(Intensity.Grey(1), texture.Sample(TextureLookup.At(0.5, 0)));
        Assert.Equal(Intensity.Grey(2), texture.Sample(TextureLookup.At(1, 0)));
    }

    private static void Check(int width, int height, Sphere sphere, Point3D eye, Precision precision, int laneWidth)
    {
        Texture texture = TestScenes.Random(width, height).With(new SamplingOptions { Filter = TextureFilter.Nearest });
        var scene = new Scene { Camera = new SphericalCamera(eye) };
        scene.Add(sphere, TestScenes.Shining(texture));
        RenderOptions options = new() { Width = width, Height = height, Threads = 1, Precision = precision };
        Picture seen = Renderer.Render(scene, options, laneWidth, null, default).Picture;
        for (int x = 0; x < width; x++)
        {
            for (int y = 0; y < height; y++)
            {
                Assert.True(texture.ColorMap[x, y] == seen[x, height - 1 - y], $"Texel ({x}, {y}) of {width} x {height} was not seen at its place.");
            }
        }
    }
}
