using LabRaytracer;

namespace RenderScene;

/// <summary>What the figures are made with.</summary>
/// <param name="Width">Width of the figure, pixels.</param>
/// <param name="Progress">Told the share that is done, or null.</param>
/// <param name="Stop">Stops the work.</param>
internal sealed record FigureTools(int Width, IProgress<double>? Progress, CancellationToken Stop)
{
    private const int Samples = 16;

    /// <summary>Colour of the paper that the figures are on.</summary>
    public static Intensity Paper => Intensity.Grey(0.87f);

    /// <summary>A length of the figure that is drawn for 1280 pixels.</summary>
    public int Scaled(double length) => Math.Max(1, (int)Math.Round(length * Width / 1280));

    /// <summary>Renders a scene, smooth.</summary>
    public Picture Render(Scene scene, int width, int height) =>
        Renderer.Render(scene, new RenderOptions { Width = width, Height = height, Samples = Samples }, Progress, Stop).Picture;

    /// <summary>A scene with soft light from the upper left, on the colour of the paper.</summary>
    public static Scene Studio(Camera camera)
    {
        Scene scene = new() { Camera = camera, Background = Paper };
        scene.Lights.Add(new AmbientLight(Intensity.Grey(0.35f)));
        scene.Lights.Add(new PointLight(new Point3D(-4, 6, 7), Intensity.Grey(0.72f)));
        return scene;
    }

    /// <summary>Where a camera shows a point, pixels from the top left corner of its picture.</summary>
    public static (double X, double Y) Project(PerspectiveCamera camera, Point3D point, int width, int height)
    {
        Vector3D forward = (camera.Target - camera.Eye).Normalized(), right = Vector3D.Cross(forward, Vector3D.UnitY).Normalized();
        Vector3D up = Vector3D.Cross(right, forward), to = point - camera.Eye;
        double scale = height / (2 * Math.Tan(camera.FieldOfViewDegrees * Math.PI / 360) * Vector3D.Dot(to, forward));
        return ((width / 2.0) + (scale * Vector3D.Dot(to, right)), (height / 2.0) - (scale * Vector3D.Dot(to, up)));
    }
}
