namespace LabRaytracer;

/// <summary>Ray parameters of first hits, decided and rounded by exact arithmetic: one ray at a time, slow.</summary>
/// <remarks>For the rays whose t twice the digits of a double leave open: it lies halfway between two doubles, the ray touches, or it starts on the surface.</remarks>
internal static class ExactDistance
{
    /// <summary>First hit of a sphere.</summary>
    /// <returns>t, rounded correctly; NaN if there is none with t above 0.</returns>
    public static double OfSphere(in Ray ray, Point3D center, double radius)
    {
        (ExactNumber x, ExactNumber y, ExactNumber z) = Offset(ray, center);
        (ExactNumber dx, ExactNumber dy, ExactNumber dz) = (ray.Direction.X, ray.Direction.Y, ray.Direction.Z);
        ExactQuadratic quadratic = new(
            (dx * dx) + (dy * dy) + (dz * dz), (x * dx) + (y * dy) + (z * dz), (x * x) + (y * y) + (z * z) - ((ExactNumber)radius * radius));
        return !quadratic.HasRoots ? double.NaN
            : quadratic.Compare(false, 0, 1) > 0 ? quadratic.Nearest(false)
            : quadratic.Compare(true, 0, 1) > 0 ? quadratic.Nearest(true)
            : double.NaN;
    }

    /// <summary>First hit of the side of an upright cylinder.</summary>
    /// <returns>t, rounded correctly; NaN if there is none with t above 0.</returns>
    public static double OfCylinder(in Ray ray, Point3D center, double radius, double halfHeight)
    {
        (ExactNumber x, ExactNumber y, ExactNumber z) = Offset(ray, center);
        (ExactNumber dx, ExactNumber dy, ExactNumber dz) = (ray.Direction.X, ray.Direction.Y, ray.Direction.Z);
        ExactQuadratic quadratic = new((dx * dx) + (dz * dz), (x * dx) + (z * dz), (x * x) + (z * z) - ((ExactNumber)radius * radius));
        if ((dx.Sign == 0 && dz.Sign == 0) || !quadratic.HasRoots)
        {
            return double.NaN;
        }

        foreach (bool isFar in (ReadOnlySpan<bool>)[false, true])
        {
            // y + t dy <= h and >= -h, as comparisons of t with (+-h - y) / dy.
            int below = dy.Sign == 0 ? (y - halfHeight).Sign : quadratic.Compare(isFar, halfHeight - y, dy) * dy.Sign;
            int above = dy.Sign == 0 ? (y + halfHeight).Sign : quadratic.Compare(isFar, -halfHeight - y, dy) * dy.Sign;
            if (below <= 0 && above >= 0 && quadratic.Compare(isFar, 0, 1) > 0)
            {
                return quadratic.Nearest(isFar);
            }
        }

        return double.NaN;
    }

    /// <summary>Hit of a plane.</summary>
    /// <returns>t, rounded correctly; NaN if there is none above 0.</returns>
    public static double OfPlane(in Ray ray, Point3D point, Vector3D normal)
    {
        (ExactNumber x, ExactNumber y, ExactNumber z) = Offset(ray, point);
        ExactNumber height = -((x * normal.X) + (y * normal.Y) + (z * normal.Z));
        ExactNumber approach = ((ExactNumber)normal.X * ray.Direction.X) + ((ExactNumber)normal.Y * ray.Direction.Y) + ((ExactNumber)normal.Z * ray.Direction.Z);
        return height.Sign * approach.Sign > 0
            ? ExactNumber.Nearest(number => (height - (number * approach)).Sign * approach.Sign)
            : double.NaN;
    }

    private static (ExactNumber X, ExactNumber Y, ExactNumber Z) Offset(in Ray ray, Point3D from) =>
        (ray.Origin.X - (ExactNumber)from.X, ray.Origin.Y - (ExactNumber)from.Y, ray.Origin.Z - (ExactNumber)from.Z);
}
