namespace Exercises;

/// <summary>Exercise 3: spherical mapping, lab sheet IV, section 1.1.3.</summary>
public sealed class SphericalExercise : IMapping
{
    /// <summary>
    /// phi as on the cylinder, theta the angle from +y; u = phi / 2 pi, v = 1 - theta / pi.
    /// Mind points whose distance from the origin is not exactly 1: rounding makes such points at the poles, and acos(1.0000000000000002) is not a number.
    /// </summary>
    public TextureCoordinate Map(in SurfacePosition position)
    {
        Point3D p = position.LocalPoint;
        throw new NotImplementedException($"Exercise 3: u and v of {p}.");
    }
}
