namespace LabRaytracer;

/// <summary>Mappings of scene files that have numbers of their own.</summary>
internal static class MappingObjectFormats
{
    private static readonly Key<LightProbeFacing> s_facing = Key.Optional(
        "facing", ChoiceFormat.Of<LightProbeFacing>(), LightProbeFacing.PositiveZ, "The direction in the middle of the picture.");

    private static readonly Key<double> s_ringRadius = Key.Optional("ringRadius", NumberFormat.Positive, 1, "Radius of the ring, local units.");

    private static readonly Key<Point3D> s_eye = Key.Required("eye", Coordinates.Point, "Where the projector stands.");

    private static readonly Key<Point3D> s_target = Key.Optional("target", Coordinates.Point, Point3D.Origin, "The point in the middle of its picture.");

    private static readonly Key<Vector3D> s_up = Key.Optional("up", Coordinates.Direction, Vector3D.UnitY, "What is up in its picture.");

    private static readonly Key<double> s_fieldOfView = Key.Optional(
        "fieldOfViewDegrees", new NumberFormat { Above = 0, Below = 180 }, 40, "Vertical angle of its picture, degrees.");

    private static readonly Key<double> s_aspect = Key.Optional("aspect", NumberFormat.Positive, 1, "Width of its picture over its height.");

    private static readonly Key<TextureFrame> s_frame = Key.Optional(
        "frame", ChoiceFormat.Of<TextureFrame>(), TextureFrame.Object, "The space that eye, target and up are given in: the object's local space, or the world.");

    /// <summary>The formats.</summary>
    public static IReadOnlyList<ObjectFormat<IMapping>> All { get; } =
    [
        new("lightProbeMapping", "All directions on one disk.", [s_facing], fields => new LightProbeMapping { Facing = fields.Get(s_facing) }, ("type", "lightProbe")),
        new("torusMapping", "The angles around the ring and around the tube of a torus.", [s_ringRadius], fields => new TorusMapping(fields.Get(s_ringRadius)), ("type", "torus")),
        new("projectorMapping", "A slide projector.", [s_eye, s_target, s_up, s_fieldOfView, s_aspect, s_frame], Projector, ("type", "projector")),
    ];

    private static ProjectorMapping? Projector(Fields fields) => fields.Make(
        s_target,
        () => new ProjectorMapping(
            fields.Get(s_eye), fields.Get(s_target), fields.Get(s_up), fields.Get(s_fieldOfView), fields.Get(s_aspect), fields.Get(s_frame)),
        "the projector has no line of sight, or its up direction lies along it",
        "a target other than the eye, and an up direction beside the line between them");
}
