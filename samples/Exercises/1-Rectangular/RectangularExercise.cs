namespace Exercises;

/// <summary>Exercise 1: rectangular mapping, lab sheet IV, section 1.1.1.</summary>
public sealed class RectangularExercise : IMapping
{
    /// <summary>
    /// The square [-1, 1] x [-1, 1] of the plane y = 0 becomes the picture: u grows with z, v with x, both from 0 to 1.
    /// Mind the sheet's formula of v: what does it give for x = 0?
    /// </summary>
    public TextureCoordinate Map(in SurfacePosition position)
    {
        Point3D p = position.LocalPoint;
        throw new NotImplementedException($"Exercise 1: u and v of {p}.");
    }
}
