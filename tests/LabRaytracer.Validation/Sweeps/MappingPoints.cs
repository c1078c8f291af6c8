namespace LabRaytracer.Validation;

/// <summary>Local points that mappings find hard.</summary>
internal static class MappingPoints
{
    /// <summary>Points of all classes in turn.</summary>
    /// <param name="draws">Random numbers.</param>
    /// <param name="count">How many.</param>
    /// <param name="isSingle">True to round to float, and to keep magnitudes inside its range.</param>
    public static Point3D[] Create(Draws draws, int count, bool isSingle)
    {
        Point3D[] points = new Point3D[count];
        for (int i = 0; i < count; i++)
        {
            Point3D p = OfKind(draws, i % 10, isSingle);
            points[i] = isSingle ? new Point3D((float)p.X, (float)p.Y, (float)p.Z) : p;
        }

        return points;
    }

    private static Point3D OfKind(Draws draws, int kind, bool isSingle)
    {
        Vector3D d = draws.Direction();
        double most = isSingle ? 37 : 300, tiny = isSingle ? -44 : -320;
        return kind switch
        {
            0 => Point3D.Origin + d,
            1 => Point3D.Origin + (d * (1 + (draws.Sign() * draws.Scale(-16, -3)))),
            2 => Point3D.Origin + (d * draws.Scale(-most, most)),
            3 => new Point3D(draws.Sign() * draws.Scale(tiny, 0), draws.Sign(), draws.Sign() * draws.Scale(tiny, 0)),
            4 => new Point3D(draws.Sign() * draws.Scale(tiny, 0), d.Y, Math.Abs(d.Z)),
            5 => Axis(draws, draws.Integer(27)),
            6 => Diagonal(draws, d),
            7 => new Point3D(draws.Sign() * draws.Scale(-most, most), draws.Sign() * draws.Scale(-most, most), draws.Sign() * draws.Scale(-most, most)),
            8 => new Point3D(d.X * 0.001, d.Y * draws.Scale(-8, 8), d.Z),
            _ => new Point3D(d.X, draws.Sign() * (1 + draws.Number(0, 1e-15)), d.Z * draws.Scale(-20, 0)),
        };
    }

    /// <summary>The 26 directions along axes and diagonals, and the origin, with zeros of both signs.</summary>
    private static Point3D Axis(Draws draws, int number)
    {
        double Part(int digit) => digit == 0 ? draws.Sign() * 0.0 : digit == 1 ? 1 : -1;
        return new Point3D(Part(number % 3), Part(number / 3 % 3), Part(number / 9));
    }

    /// <summary>Where the angle changes its formula: |x| = |z| or |y| = rho up to an ulp.</summary>
    private static Point3D Diagonal(Draws draws, Vector3D d)
    {
        double Near(double a) => draws.Sign() * (draws.Integer(3) switch { 0 => a, 1 => Math.BitIncrement(a), _ => Math.BitDecrement(a) });
        double rho = Math.Sqrt((d.X * d.X) + (d.Z * d.Z));
        return draws.Sign() > 0 ? new Point3D(d.X, d.Y, Near(Math.Abs(d.X))) : new Point3D(d.X, Near(rho), d.Z);
    }
}
