namespace LabRaytracer;

/// <summary>How far points and boxes reach along -x, -y, -z (lanes 0 to 2) and +x, +y, +z (lanes 4 to 6), in floats: the union of boxes is one maximum.</summary>
internal static class BvhReach
{
    /// <summary>The reach of a point, rounded outward.</summary>
    /// <param name="point">The point.</param>
    /// <param name="center">Subtracted from it.</param>
    public static Float8 Of(Point3D point, Point3D center) => Float8.Join(
        Float4.Of(Above(-point.X, -center.X), Above(-point.Y, -center.Y), Above(-point.Z, -center.Z)),
        Float4.Of(Above(point.X, center.X), Above(point.Y, center.Y), Above(point.Z, center.Z)));

    /// <summary>A float not below value - center; a further step up covers the rounding of the subtraction.</summary>
    private static float Above(double value, double center)
    {
        double difference = value - center;
        float above = (float)difference;
        if (above < difference)
        {
            above = MathF.BitIncrement(above);
        }

        return center == 0 ? above : MathF.BitIncrement(above);
    }
}
