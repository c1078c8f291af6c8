using LabRaytracer;

namespace RenderScene;

/// <summary>Figures 4, 5, 6 and 8: pictures on surfaces.</summary>
internal static class SurfaceFigures
{
    private const double Azimuth = 62, Height = 0.35, Side = 600;

    /// <summary>Figure 4: a point p on a cylinder, and the same point in the picture.</summary>
    public static Picture Cylinder(FigureTools tools)
    {
        PerspectiveCamera camera = Camera(35, 22, 7.5, 28);
        Point3D p = new(Math.Sin(Radians(Azimuth)), Height, Math.Cos(Radians(Azimuth)));
        GridTexture grid = new() { Columns = 24, Rows = 8 };
        return Explained(tools, camera, new Cylinder(), grid, p, (Azimuth / 360, (Height + 1) / 2), "y");
    }

    /// <summary>Figure 5: a sphere wrapped like a box and like a globe.</summary>
    public static Picture Wrapped(FigureTools tools)
    {
        int side = tools.Width / 2, height = tools.Scaled(560);
        Canvas canvas = new(tools.Width, height + tools.Scaled(60), FigureTools.Paper);
        Material flat = new() { Diffuse = new TextureSlot { Texture = new GridTexture(), Mapping = new RectangularMapping() } };
        canvas.Paste(tools.Render(OneObject(Camera(62, 24, 7.5, 19), new Sphere(), flat), side, height), 0, 0);
        canvas.Paste(tools.Render(OneObject(Camera(62, 24, 7.5, 19), new Sphere(), Material.Matte(new GridTexture())), tools.Width - side, height), side, 0);
        canvas.Label("rectangular mapping", side / 2.0, height + tools.Scaled(28), tools.Scaled(18));
        canvas.Label("spherical mapping", 1.5 * side, height + tools.Scaled(28), tools.Scaled(18));
        return canvas.Picture;
    }

    /// <summary>Figure 6: a point p on the unit sphere, and the same point in the picture.</summary>
    public static Picture Sphere(FigureTools tools)
    {
        const double PolarAngle = 52;
        PerspectiveCamera camera = Camera(35, 22, 7.5, 28);
        double ring = Math.Sin(Radians(PolarAngle));
        Point3D p = new(ring * Math.Sin(Radians(Azimuth)), Math.Cos(Radians(PolarAngle)), ring * Math.Cos(Radians(Azimuth)));
        return Explained(tools, camera, new Sphere(), new GridTexture(), p, (Azimuth / 360, 1 - (PolarAngle / 180)), "\u03b8");
    }

    /// <summary>Figure 8: the grid on the sphere, seen towards the seam and from above the north pole.</summary>
    public static Picture Grid(FigureTools tools)
    {
        int side = tools.Width / 2, height = tools.Scaled(580);
        Canvas canvas = new(tools.Width, height + tools.Scaled(60), FigureTools.Paper);
        Material grid = Material.Matte(new GridTexture());
        canvas.Paste(tools.Render(OneObject(Camera(0, 12, 7.5, 18.5), new Sphere(), grid), side, height), 0, 0);
        canvas.Paste(tools.Render(OneObject(Camera(0, 78, 7.5, 18.5), new Sphere(), grid), tools.Width - side, height), side, 0);
        canvas.Label("the half plane x = 0, z > 0", side / 2.0, height + tools.Scaled(28), tools.Scaled(16));
        canvas.Label("the pole y = 1", 1.5 * side, height + tools.Scaled(28), tools.Scaled(16));
        return canvas.Picture;
    }

    /// <summary>A shape with axes and a point on the left, its texture with the same point on the right.</summary>
    private static Picture Explained(FigureTools tools, PerspectiveCamera camera, Shape shape, ITexture texture, Point3D p, (double U, double V) at, string upward)
    {
        int side = tools.Scaled(Side), width = tools.Scaled(560), flat = width / 2, left = tools.Width - width - tools.Scaled(70), top = (side - flat) / 2;
        Canvas canvas = new(tools.Width, side, FigureTools.Paper);
        canvas.Paste(tools.Render(OneObject(camera, shape, Material.Matte(texture)), side, side), 0, 0);
        DrawSpace(canvas, tools, camera, p, shape is Sphere);
        canvas.Flat(texture, left, top, width, flat);
        canvas.Ink = Intensity.Black;
        canvas.Frame(left, top, width, flat);
        double x = left + (at.U * width), y = top + ((1 - at.V) * flat), text = tools.Scaled(18);
        canvas.Ink = new Intensity(0.6f, 0.02f, 0.02f);
        canvas.Arrow(left, top + flat, left + width + tools.Scaled(30), top + flat, tools.Scaled(3));
        canvas.Label("u", left + width + tools.Scaled(42), top + flat + tools.Scaled(6), text);
        canvas.Label("0", left, top + flat + tools.Scaled(30), text);
        canvas.Label("\u03c6 = 2\u03c0", left + width, top + flat + tools.Scaled(30), text);
        canvas.Ink = new Intensity(0.02f, 0.1f, 0.6f);
        canvas.Arrow(left, top + flat, left, top - tools.Scaled(30), tools.Scaled(3));
        canvas.Label("v", left, top - tools.Scaled(38), text);
        (string low, string high) = upward == "y" ? ("y=-1", "y=1") : ("\u03b8=\u03c0", "\u03b8=0");
        canvas.Label(low, left - tools.Scaled(38), top + flat, tools.Scaled(15));
        canvas.Label(high, left - tools.Scaled(38), top + tools.Scaled(12), tools.Scaled(15));
        DrawPoint(canvas, tools, x, y);
        canvas.Line(x, y, x, top + flat, 2);
        canvas.Line(x, y, left, y, 2);
        return canvas.Picture;
    }

    /// <summary>The axes x, y, z, the angle phi from +z towards +x, on a sphere the angle theta from +y, and the point p.</summary>
    private static void DrawSpace(Canvas canvas, FigureTools tools, PerspectiveCamera camera, Point3D p, bool isOnSphere)
    {
        int side = tools.Scaled(Side);
        (double X, double Y) To(double x, double y, double z) => FigureTools.Project(camera, new Point3D(x, y, z), side, side);
        (string Name, Vector3D Axis)[] axes = [("x", Vector3D.UnitX), ("y", Vector3D.UnitY), ("z", Vector3D.UnitZ)];
        foreach ((string name, Vector3D axis) in axes)
        {
            (double fromX, double fromY) = To(1.02 * axis.X, 1.02 * axis.Y, 1.02 * axis.Z);
            (double toX, double toY) = To(1.5 * axis.X, 1.5 * axis.Y, 1.5 * axis.Z);
            (double textX, double textY) = To(1.62 * axis.X, 1.62 * axis.Y, 1.62 * axis.Z);
            canvas.Arrow(fromX, fromY, toX, toY, tools.Scaled(3));
            canvas.Label(name, textX, textY + tools.Scaled(7), tools.Scaled(18));
        }

        canvas.Ink = new Intensity(0.55f, 0.02f, 0.3f);
        double ring = Math.Sqrt((p.X * p.X) + (p.Z * p.Z)) * 1.012;
        canvas.Path(Enumerable.Range(0, 41).Select(i => Radians(Azimuth * i / 40)).Select(phi => To(ring * Math.Sin(phi), p.Y, ring * Math.Cos(phi))), tools.Scaled(4));
        (double labelX, double labelY) = To(1.16 * ring * Math.Sin(Radians(Azimuth / 2)), p.Y - 0.12, 1.16 * ring * Math.Cos(Radians(Azimuth / 2)));
        DrawName(canvas, tools, "\u03c6", labelX, labelY);
        if (isOnSphere)
        {
            double theta = Math.Atan2(ring, p.Y);
            canvas.Path(Enumerable.Range(0, 41).Select(i => theta * i / 40).Select(angle => To(1.012 * Math.Sin(angle) * Math.Sin(Radians(Azimuth)), 1.012 * Math.Cos(angle), 1.012 * Math.Sin(angle) * Math.Cos(Radians(Azimuth)))), tools.Scaled(4));
            (labelX, labelY) = To(0.75 * Math.Sin(Radians(Azimuth + 12)), 0.92, 0.75 * Math.Cos(Radians(Azimuth + 12)));
            DrawName(canvas, tools, "\u03b8", labelX, labelY);
        }

        (double x, double y) = To(p.X, p.Y, p.Z);
        DrawPoint(canvas, tools, x, y);
    }

    /// <summary>A letter on a white spot.</summary>
    private static void DrawName(Canvas canvas, FigureTools tools, string name, double x, double y)
    {
        Intensity ink = canvas.Ink;
        canvas.Ink = Intensity.White;
        canvas.Dot(x, y, tools.Scaled(30));
        canvas.Ink = ink;
        canvas.Label(name, x, y + tools.Scaled(8), tools.Scaled(19));
    }

    private static void DrawPoint(Canvas canvas, FigureTools tools, double x, double y)
    {
        canvas.Ink = Intensity.White;
        canvas.Dot(x, y, tools.Scaled(20));
        canvas.Dot(x + tools.Scaled(20), y - tools.Scaled(18), tools.Scaled(26));
        canvas.Ink = new Intensity(0.45f, 0, 0.5f);
        canvas.Dot(x, y, tools.Scaled(14));
        canvas.Label("p", x + tools.Scaled(20), y - tools.Scaled(14), tools.Scaled(20));
    }

    private static Scene OneObject(PerspectiveCamera camera, Shape shape, Material material)
    {
        Scene scene = new() { Camera = camera, Background = FigureTools.Paper };
        scene.Lights.Add(new AmbientLight(Intensity.Grey(0.62f)));
        scene.Lights.Add(new PointLight(camera.Eye + new Vector3D(-2.5, 4, 1), Intensity.Grey(0.42f)));
        scene.Add(shape, material);
        return scene;
    }

    /// <summary>A camera that looks at the origin.</summary>
    private static PerspectiveCamera Camera(double azimuth, double elevation, double distance, double fieldOfView) => new(
        new Point3D(
            distance * Math.Cos(Radians(elevation)) * Math.Sin(Radians(azimuth)),
            distance * Math.Sin(Radians(elevation)),
            distance * Math.Cos(Radians(elevation)) * Math.Cos(Radians(azimuth))),
        Point3D.Origin,
        fieldOfView);

    private static double Radians(double degrees) => degrees * Math.PI / 180;
}
