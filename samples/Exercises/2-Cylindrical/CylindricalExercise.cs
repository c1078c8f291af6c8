namespace Exercises;

/// <summary>Exercise 2: cylindrical mapping, lab sheet IV, section 1.1.2.</summary>
public sealed class CylindricalExercise : IMapping
{
    /// <summary>
    /// phi is the angle around the y axis, 0 towards +z, growing towards +x; u = phi / 2 pi in [0, 1), v = (y + 1) / 2.
    /// Mind the quadrants: tan^-1(x / z) cannot tell (1, 1) from (-1, -1).
    /// </summary>
    public TextureCoordinate Map(in SurfacePosition position)
    {
        Point3D p = position.LocalPoint;
        throw new NotImplementedException($"Exercise 2: u and v of {p}.");
    }
}
