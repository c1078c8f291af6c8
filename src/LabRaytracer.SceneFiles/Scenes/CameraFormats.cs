namespace LabRaytracer;

/// <summary>Cameras of scene files.</summary>
internal static class CameraFormats
{
    private static readonly Key<Point3D> s_eye = Key.Required("eye", Coordinates.Point, "Where the camera stands, world space.");

    private static readonly Key<Point3D> s_target = Key.Optional("target", Coordinates.Point, Point3D.Origin, "The point in the middle of the picture, world space.");

    private static readonly Key<Vector3D> s_up = Key.Optional("up", Coordinates.Direction, Vector3D.UnitY, "What is up on the picture, world space; not along the line of sight.");

    private static readonly Key<double> s_fieldOfView = Key.Optional(
        "fieldOfViewDegrees", new NumberFormat { Above = 0, Below = 180 }, 40, "Vertical angle of view, degrees.");

    /// <summary>A camera, told by its type.</summary>
    public static VariantFormat<Camera> Any { get; } = new(
        "type",
        "The camera.",
        [
            new("perspectiveCamera", "A pinhole camera.", [s_eye, s_target, s_up, s_fieldOfView], Perspective, ("type", "perspective")),
        ]);

    private static PerspectiveCamera Perspective(Fields fields) =>
        new(fields.Get(s_eye), fields.Get(s_target), fields.Get(s_fieldOfView), fields.Get(s_up));
}
