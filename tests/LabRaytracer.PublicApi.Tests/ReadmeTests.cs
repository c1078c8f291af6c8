namespace LabRaytracer.PublicApi.Tests;

/// <summary>The example of README.md runs and does what it says.</summary>
public sealed class ReadmeTests
{
    [Fact]
    public void Example_TexturesASphere()
    {
        string folder = Directory.CreateTempSubdirectory("labraytracer-").FullName, before = Environment.CurrentDirectory;
        try
        {
            Environment.CurrentDirectory = folder;
            Example();
            Picture picture = Picture.Load("ball.png");
            Assert.Equal((640, 480), (picture.Width, picture.Height));
            Assert.NotEqual(picture[320, 240], picture[2, 2]);
        }
        finally
        {
            Environment.CurrentDirectory = before;
            Directory.Delete(folder, recursive: true);
        }
    }

    private static void Example()
    {
        #region snippet readme
        var texture = new Texture(8, 4);                    // the lab's class: Width, Height, ColorMap[x, y]
        for (int x = 0; x < texture.Width; x++)
        {
            for (int y = 0; y < texture.Height; y++)        // y = 0 is the bottom row, as in y_p = (v_res - 1) v
            {
                texture.ColorMap[x, y] = new Intensity(x / 8f, y / 4f, (x + y) % 2);
            }
        }

        var material = new Material { Diffuse = texture, Specular = Intensity.Grey(0.4f), Shininess = 40 };
        var scene = new Scene { Camera = new PerspectiveCamera(new Point3D(0, 1, -4), Point3D.Origin, 40) };
        scene.Add(new Sphere(), material);                  // spherical mapping, section 1.1.3
        scene.Lights.Add(new AmbientLight(Intensity.Grey(0.2f)));
        scene.Lights.Add(new PointLight(new Point3D(3, 4, -5), Intensity.White));

        RenderResult result = Renderer.Render(scene, new RenderOptions { Width = 640, Height = 480, Samples = 9 });
        result.Picture.Save("ball.png");
        #endregion
    }
}
