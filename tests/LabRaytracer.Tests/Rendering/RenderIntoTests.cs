namespace LabRaytracer.Tests.Rendering;

/// <summary>Renders into a picture that is there already.</summary>
public sealed class RenderIntoTests
{
    /// <summary>Every pixel is written, whatever was there.</summary>
    [Theory]
    [InlineData(false, 0)]
    [InlineData(true, 0)]
    [InlineData(false, 1)]
    [InlineData(true, 1)]
    public void RenderInto_UsedPicture_SameBitsAsANewOne(bool isCropped, double budget)
    {
        Scene scene = Ball();
        PixelRectangle? crop = isCropped ? new PixelRectangle(37, 5, 23, 31) : null;
        RenderOptions options = new() { Width = 70, Height = 41, Threads = 2, Crop = crop, ErrorBudget = budget, MaxSamples = 16 };
        Picture expected = Renderer.Render(scene, options).Picture, picture = new(crop?.Width ?? 70, crop?.Height ?? 41);
        for (int frame = 0; frame < 2; frame++)
        {
            picture.Pixels.Fill(Intensity.Grey(float.NaN));
            RenderStatistics statistics = Renderer.RenderInto(scene, options, picture);
            Assert.Equal(expected.Pixels.ToArray(), picture.Pixels.ToArray());
            Assert.True(statistics.PrimaryRays >= picture.Width * picture.Height);
        }
    }

    [Fact]
    public void RenderInto_OtherSize_SaysBoth()
    {
        ArgumentException failure = Assert.Throws<ArgumentException>(() => Renderer.RenderInto(Ball(), new RenderOptions { Width = 70, Height = 41 }, new Picture(41, 70)));
        Assert.Contains("41 x 70", failure.Message);
        Assert.Contains("70 x 41", failure.Message);
    }

    private static Scene Ball()
    {
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0, 1, 4), Point3D.Origin, 40) };
        scene.Add(new Sphere(), new Material { Diffuse = new Intensity(0.5f, 0.25f, 0.125f) });
        scene.Lights.Add(new PointLight(new Point3D(3, 4, 5), Intensity.White));
        return scene;
    }
}
