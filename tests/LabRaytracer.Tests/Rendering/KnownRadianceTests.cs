namespace LabRaytracer.Tests.Rendering;

/// <summary>Scenes whose light is known in closed form.</summary>
public sealed class KnownRadianceTests
{
    [Fact]
    public void Furnace_WhiteThingsInWhiteAmbientLight_AreExactlyWhite()
    {
        var scene = new Scene { Background = Intensity.White };
        scene.Lights.Add(new AmbientLight(Intensity.White));
        scene.Add(new Sphere(), new Material());
        scene.Add(new InfinitePlane(new Point3D(0, -1, 0), Vector3D.UnitY), new Material { Shader = LambertShader.Default });
        Picture picture = TestScenes.Render(scene, 40, 30);
        Assert.All(picture.Pixels.ToArray(), pixel => Assert.Equal(Intensity.White, pixel));
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void PointLight_AbovePlane_FollowsLambertsCosine(bool fades)
    {
        // k_d I h / d with d = sqrt(h^2 + x^2 + z^2); with inverse-square fading k_d I h / d^3.
        const double Light = 1.5, Diffuse = 0.5, Side = 40;
        const double Above = 1.25;
        var scene = new Scene { Camera = new OrthographicCamera(new Point3D(0, 5, 0), Point3D.Origin, 4, Vector3D.UnitX) };
        scene.Add(new InfinitePlane(), new Material { Diffuse = Intensity.Grey((float)Diffuse) });
        scene.Lights.Add(new PointLight(new Point3D(0, Above, 0), Intensity.Grey((float)Light))
        {
            Attenuation = fades ? new Attenuation(0, 0, 1) : Attenuation.None,
        });
        Picture picture = TestScenes.Render(scene, (int)Side, (int)Side);
        for (int row = 0; row < Side; row++)
        {
            for (int column = 0; column < Side; column++)
            {
                double z = (4 * (column + 0.5) / Side) - 2, x = 2 - (4 * (row + 0.5) / Side);
                double d = Math.Sqrt((Above * Above) + (x * x) + (z * z));
                double expected = Diffuse * Light * Above / d / (fades ? d * d : 1);
                Assert.InRange(picture[column, row].G / expected, 1 - 5e-7, 1 + 5e-7);
            }
        }
    }

    [Fact]
    public void SphereAboveFloor_SunFromAbove_ShadowIsTheUnitDisk()
    {
        // The camera looks down from between sphere and floor.
        var scene = new Scene { Camera = new OrthographicCamera(new Point3D(0, 1.5, 0), Point3D.Origin, 4, Vector3D.UnitX) };
        scene.Lights.Add(new DirectionalLight(-Vector3D.UnitY, Intensity.Grey(0.75f)));
        scene.Add(new InfinitePlane(), new Material { Diffuse = Intensity.Grey(0.5f) });
        scene.Add(new Sphere(new Point3D(0, 3, 0)), new Material());
        Picture picture = TestScenes.Render(scene, 64, 64);
        for (int row = 0; row < 64; row++)
        {
            for (int column = 0; column < 64; column++)
            {
                double z = (column + 0.5 - 32) / 16, x = (32 - row - 0.5) / 16;
                Assert.Equal(Math.Sqrt((x * x) + (z * z)) < 1 ? 0 : 0.375f, picture[column, row].R);
            }
        }

        scene.Objects[1] = new SceneObject(new Sphere(new Point3D(0, 3, 0)), new Material()) { CastsShadows = false };
        Assert.All(TestScenes.Render(scene, 64, 64).Pixels.ToArray(), pixel => Assert.Equal(0.375f, pixel.R));
    }

    [Theory]
    [InlineData(1e-3, Precision.Double)]
    [InlineData(1, Precision.Double)]
    [InlineData(1e6, Precision.Double)]
    [InlineData(1e-3, Precision.Single)]
    [InlineData(1, Precision.Single)]
    [InlineData(1e6, Precision.Single)]
    public void ConvexThings_NeverShadowThemselves(double size, Precision precision)
    {
        var scene = new Scene { Camera = new PerspectiveCamera(new Point3D(3 * size, 2 * size, 4 * size), new Point3D(0.2 * size, 0, 0), 50) };
        scene.Add(new Sphere(new Point3D(size, 0.1 * size, 0), size), new Material());
        void Light(bool castsShadows)
        {
            scene.Lights.Clear();
            scene.Lights.Add(new PointLight(new Point3D(5 * size, 1.5 * size, 2 * size), Intensity.White) { CastsShadows = castsShadows });
        }

        RenderOptions options = new() { Width = 64, Height = 48, Threads = 1, Precision = precision };
        Light(false);
        Picture lit = Renderer.Render(scene, options).Picture;
        Light(true);
        PictureAssert.SameBits(lit, Renderer.Render(scene, options).Picture);

        scene.Objects[0] = new SceneObject(new InfinitePlane(new Point3D(0, -size / 3, 0), new Vector3D(0.1, 1, 0.3)), new Material());
        Light(false);
        lit = Renderer.Render(scene, options).Picture;
        Light(true);
        PictureAssert.SameBits(lit, Renderer.Render(scene, options).Picture);
    }
}
