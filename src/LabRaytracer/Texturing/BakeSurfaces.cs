namespace LabRaytracer;

/// <summary>Surfaces to bake 3D textures on: the points that built-in mappings give (u, v) to.</summary>
public static class BakeSurfaces
{
    /// <summary>The unit sphere of <see cref="SphericalMapping"/>.</summary>
    /// <param name="at">u around, v from the south pole to the north pole.</param>
    public static SurfacePosition Sphere(TextureCoordinate at)
    {
        (double sinPhi, double cosPhi) = Elementary.SinCosDegrees(360 * at.U);
        (double sinTheta, double cosTheta) = Elementary.SinCosDegrees(180 * (1 - at.V));
        Vector3D normal = new(sinTheta * sinPhi, cosTheta, sinTheta * cosPhi);
        return new SurfacePosition(Point3D.Origin + normal, normal, at);
    }

    /// <summary>The side of the unit cylinder of <see cref="CylindricalMapping"/>.</summary>
    /// <param name="at">u around, v from bottom to top.</param>
    public static SurfacePosition Cylinder(TextureCoordinate at)
    {
        (double sin, double cos) = Elementary.SinCosDegrees(360 * at.U);
        return new SurfacePosition(new Point3D(sin, (2 * at.V) - 1, cos), new Vector3D(sin, 0, cos), at);
    }

    /// <summary>The square of <see cref="RectangularMapping"/> in the plane y = 0.</summary>
    /// <param name="at">u along z, v along x.</param>
    public static SurfacePosition Rectangle(TextureCoordinate at) => new(new Point3D((2 * at.V) - 1, 0, (2 * at.U) - 1), Vector3D.UnitY, at);
}
