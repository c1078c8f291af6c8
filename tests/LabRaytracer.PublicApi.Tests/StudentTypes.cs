namespace LabRaytracer.PublicApi.Tests;

#region snippet mapping
/// <summary>The sheet's cylindrical mapping, section 1.1.2, by one's own hand.</summary>
internal sealed class MyCylindricalMapping : IMapping
{
    public TextureCoordinate Map(in SurfacePosition position)
    {
        Point3D p = position.LocalPoint;
        double phi = Math.Atan2(p.X, p.Z);
        double u = (phi < 0 ? phi + (2 * Math.PI) : phi) / (2 * Math.PI);
        return new TextureCoordinate(u, (p.Y + 1) / 2);
    }
}
#endregion

#region snippet texture
/// <summary>Rings around the middle of the picture.</summary>
internal sealed class Rings(Intensity light, Intensity dark, int count) : ITexture
{
    public Intensity Sample(in TextureLookup lookup)
    {
        double x = lookup.Coordinate.U - 0.5, y = lookup.Coordinate.V - 0.5;
        double ring = Math.Floor(2 * count * Math.Sqrt((x * x) + (y * y)));
        return ring % 2 == 0 ? light : dark;
    }
}
#endregion

#region snippet shape
/// <summary>A sphere of radius 1 around the origin, by the quadratic formula.</summary>
internal sealed class MySphere : Shape
{
    public override Bounds Bounds => new(new Point3D(-1, -1, -1), new Point3D(1, 1, 1));

    public override IMapping DefaultMapping { get; } = new SphericalMapping();

    public override bool Intersect(in Ray ray, double limit, out Hit hit)
    {
        Vector3D o = ray.Origin.ToVector(), d = ray.Direction;
        double a = Vector3D.Dot(d, d), b = Vector3D.Dot(o, d), c = Vector3D.Dot(o, o) - 1;
        double discriminant = (b * b) - (a * c);
        double root = Math.Sqrt(Math.Max(discriminant, 0)), near = (-b - root) / a, far = (-b + root) / a;
        double t = near > 0 ? near : far;
        hit = new Hit(t);
        return discriminant >= 0 && t > 0 && t < limit;
    }

    public override SurfacePoint SurfaceAt(in Ray ray, in Hit hit)
    {
        Vector3D normal = ray.PointAt(hit.T).ToVector().Normalized();
        Point3D point = Point3D.Origin + normal;
        return new SurfacePoint(point, normal, normal, new SurfacePosition(point, normal, default), Slack: 1e-12);
    }
}
#endregion

#region snippet light
/// <summary>The sun: parallel light, cut off above a ceiling.</summary>
internal sealed class Ceiling(double height, Intensity intensity) : Light
{
    public override bool TrySample(Point3D point, out LightSample sample)
    {
        sample = new LightSample(Vector3D.UnitY, double.PositiveInfinity, intensity);
        return point.Y < height;
    }
}
#endregion

#region snippet shader
/// <summary>Light in steps, as in a comic.</summary>
internal sealed class ToonShader(int steps) : IShader
{
    public bool UsesSpecular => false;

    public Intensity Reflect(in SurfaceValues values, Vector3D normal, Vector3D toLight, Vector3D toViewer)
    {
        double cosine = Vector3D.Dot(normal, toLight);
        return values.Diffuse * (float)(Math.Ceiling(cosine * steps) / steps);
    }
}
#endregion

#region snippet camera
/// <summary>A fisheye: the angle from the axis -Z grows with the distance from the picture's middle.</summary>
internal sealed class Fisheye(Point3D eye, double degrees) : Camera
{
    public override Ray RayAt(double x, double y, int width, int height)
    {
        double right = ((2 * x) - width) / height, up = (height - (2 * y)) / height;
        double radius = Math.Sqrt((right * right) + (up * up));
        double angle = radius * degrees / 2 * Math.PI / 180;
        double aside = radius > 0 ? Math.Sin(angle) / radius : 0;
        return new Ray(eye, new Vector3D(right * aside, up * aside, -Math.Cos(angle)).Normalized());
    }
}
#endregion
