namespace LabRaytracer;

/// <summary>Cameras of scene files.</summary>
internal static class CameraFormats
{
    private static readonly Key<Point3D> s_eye = Key.Required("eye", Coordinates.Point, "Where the camera stands, world space.");

    private static readonly Key<Point3D> s_target = Key.Optional("target", Coordinates.Point, Point3D.Origin, "The point in the middle of the picture, world space.");

    private static readonly Key<Vector3D> s_up = Key.Optional("up", Coordinates.Direction, Vector3D.UnitY, "What is up on the picture, world space; not along the line of sight.");

    private static readonly Key<double> s_fieldOfView = Key.Optional(
        "fieldOfViewDegrees", new NumberFormat { Above = 0, Below = 180 }, 40, "Vertical angle of view, degrees.");

    private static readonly Key<double> s_height = Key.Required("height", NumberFormat.Positive, "Height of the picture, scene units.");

    private static readonly Key<double> s_fisheyeView = Key.Optional(
        "fieldOfViewDegrees", new NumberFormat { Above = 0, Max = 360 }, 180, "Vertical angle of view, degrees: of the circle that touches top and bottom.");

    private static readonly Key<double> s_lensRadius = Key.Required(
        "lensRadius", NumberFormat.NotNegative, "Radius of the lens, scene units: the larger, the more is blurred before and behind the plane of focus.");

    private static readonly Key<double> s_focusDistance = Key.Optional(
        "focusDistance", NumberFormat.Positive, "Distance of the plane of focus along the line of sight, scene units. Default: the plane through the target.");

    /// <summary>A camera, told by its type.</summary>
    public static VariantFormat<Camera> Any { get; } = new(
        "type",
        "The camera.",
        [
            new("perspectiveCamera", "A pinhole camera.", [s_eye, s_target, s_up, s_fieldOfView], Perspective, ("type", "perspective")),
            new("orthographicCamera", "Parallel rays: sizes do not change with distance.", [s_eye, s_target, s_up, s_height], Orthographic, ("type", "orthographic")),
            new("thinLensCamera", "A camera with a lens: sharp at one distance.", [s_eye, s_target, s_up, s_fieldOfView, s_lensRadius, s_focusDistance], Lens, ("type", "thinLens")),
            new("fisheyeCamera", "A fisheye: distance from the middle in proportion to the angle.", [s_eye, s_target, s_up, s_fisheyeView], Fisheye, ("type", "fisheye")),
            new("sphericalCamera", "All directions around a point, as a lat-long picture.", [s_eye], fields => new SphericalCamera(fields.Get(s_eye)), ("type", "spherical")),
        ]);

    private static PerspectiveCamera? Perspective(Fields fields) => LooksSomewhere(fields, () =>
        new PerspectiveCamera(fields.Get(s_eye), fields.Get(s_target), fields.Get(s_fieldOfView), fields.Get(s_up)));

    private static ThinLensCamera? Lens(Fields fields) => Perspective(fields) is { } pinhole
        ? new ThinLensCamera(pinhole, fields.Get(s_lensRadius), fields.Has(s_focusDistance) ? fields.Get(s_focusDistance) : null)
        : null;

    private static FisheyeCamera? Fisheye(Fields fields) => LooksSomewhere(fields, () =>
        new FisheyeCamera(fields.Get(s_eye), fields.Get(s_target), fields.Get(s_fisheyeView), fields.Get(s_up)));

    private static OrthographicCamera? Orthographic(Fields fields) => LooksSomewhere(fields, () =>
        new OrthographicCamera(fields.Get(s_eye), fields.Get(s_target), fields.Get(s_height), fields.Get(s_up)));

    private static T? LooksSomewhere<T>(Fields fields, Func<T> make)
        where T : Camera
    {
        if (fields.Get(s_eye) == fields.Get(s_target))
        {
            fields.Fail(s_target, "the target is where the camera stands", "any other point");
            return null;
        }

        return fields.Make(s_up, make, "the camera looks along its own up direction", "an up direction beside the line from eye to target");
    }
}
