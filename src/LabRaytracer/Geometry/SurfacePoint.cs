namespace LabRaytracer;

/// <summary>The geometry of a shape's surface at a hit, in object space.</summary>
/// <param name="Point">The hit point, object space, on the surface within <paramref name="Slack"/>.</param>
/// <param name="Normal">Outward geometric normal; length 1.</param>
/// <param name="ShadingNormal">Normal for shading (interpolated on meshes); length 1. Equal to <paramref name="Normal"/> where nothing is interpolated.</param>
/// <param name="Position">What mappings see: point and normal relative to the shape's unit form (a sphere's centre is 0, its radius 1).</param>
/// <param name="Slack">Bound of the error of each coordinate of <paramref name="Point"/>, object units, above 0. Secondary rays start outside it.</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct SurfacePoint(Point3D Point, Vector3D Normal, Vector3D ShadingNormal, SurfacePosition Position, double Slack);
