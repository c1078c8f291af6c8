namespace LabRaytracer.Tests;

/// <summary>Rectangle and cylinder unroll without distortion: distances on the surface and on the picture agree up to one scale an axis.</summary>
public sealed class IsometryTests
{
    [Fact]
    public void Rectangular_AnyTwoPoints_KeepTheirDistance()
    {
        var random = new Random(24);
        for (int i = 0; i < 1000; i++)
        {
            Point3D a = new((2 * random.NextDouble()) - 1, 0, (2 * random.NextDouble()) - 1), b = new((2 * random.NextDouble()) - 1, 0, (2 * random.NextDouble()) - 1);
            TextureCoordinate p = new RectangularMapping().Map(a), q = new RectangularMapping().Map(b);
            Assert.Equal((b - a).Length, 2 * Math.Sqrt(Math.Pow(q.U - p.U, 2) + Math.Pow(q.V - p.V, 2)), 1e-14);
        }
    }

    [Fact]
    public void Cylindrical_AnyTwoPoints_KeepTheirDistanceAlongTheSurface()
    {
        var random = new Random(24);
        for (int i = 0; i < 1000; i++)
        {
            double phi = 6 * random.NextDouble(), psi = 6 * random.NextDouble(), y = random.NextDouble(), h = -random.NextDouble();
            TextureCoordinate p = new CylindricalMapping().Map(new Point3D(Math.Sin(phi), y, Math.Cos(phi)));
            TextureCoordinate q = new CylindricalMapping().Map(new Point3D(Math.Sin(psi), h, Math.Cos(psi)));
            Assert.Equal(psi - phi, 2 * Math.PI * (q.U - p.U), 1e-14);
            Assert.Equal(h - y, 2 * (q.V - p.V), 1e-15);
        }
    }
}
