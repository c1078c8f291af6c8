namespace LabRaytracer;

/// <summary>What a mapping sees of a hit: where on the object it lies.</summary>
/// <param name="LocalPoint">The hit in object space ("local hit point" of Program 2): a unit sphere has radius 1 here.</param>
/// <param name="LocalNormal">Outward normal in object space; length 1.</param>
/// <param name="Surface">The shape's own coordinates at the hit: the interpolated vt of a mesh; (0, 0) for shapes that have none.</param>
/// <param name="SurfaceGradient">How fast <paramref name="Surface"/> changes with the local point; zero for shapes without coordinates of their own. Only set where a gradient is asked for.</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct SurfacePosition(Point3D LocalPoint, Vector3D LocalNormal, TextureCoordinate Surface, MappingGradient SurfaceGradient = default)
{
    /// <summary>The hit in world space. Set where the renderer maps hits.</summary>
    public Point3D WorldPoint { get; init; }

    /// <summary>A position known only by its local point; normal and own coordinates are zero.</summary>
    public static SurfacePosition At(double x, double y, double z) => new(new Point3D(x, y, z), default, default);
}
