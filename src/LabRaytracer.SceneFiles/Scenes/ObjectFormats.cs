namespace LabRaytracer;

/// <summary>Objects of scene files: a shape with its material and place.</summary>
internal static class ObjectFormats
{
    private static readonly Material s_white = new();

    private static readonly Key<string> s_name = Key.Optional("name", TextFormat.Instance, "", "Name for messages and statistics.");

    private static readonly Key<Material> s_material = Key.Optional("material", MaterialFormats.Any, "Name of a material, or a material in place. Default: matte white.");

    private static readonly Key<Transform> s_transform = Key.Optional(
        "transform", TransformFormats.Any, "From object space to world space: steps, applied from first to last. Default: none.");

    private static readonly Key<bool> s_castsShadows = Key.Optional("castsShadows", SwitchFormat.Instance, true, "Whether the object blocks light.");

    private static readonly Key<Point3D> s_center = Key.Optional("center", Coordinates.Point, Point3D.Origin, "Centre, object space.");

    private static readonly Key<double> s_radius = Key.Optional("radius", NumberFormat.Positive, 1, "Radius, object units.");

    private static readonly Key<Point3D> s_point = Key.Optional("point", Coordinates.Point, Point3D.Origin, "A point of the plane, object space; texture coordinates start there.");

    private static readonly Key<Vector3D> s_normal = Key.Optional("normal", Coordinates.Direction, Vector3D.UnitY, "Direction perpendicular to the plane, object space.");

    private static readonly Key<Point3D> s_middle = Key.Optional("center", Coordinates.Point, Point3D.Origin, "Middle of the axis, object space.");

    private static readonly Key<double> s_height = Key.Optional("height", NumberFormat.Positive, 2, "Height from end to end, object units.");

    private static readonly Key<Point3D> s_corner = Key.Optional("corner", Coordinates.Point, new Point3D(-1, 0, -1), "The corner with u = 0, v = 0, object space.");

    private static readonly Key<Vector3D> s_edgeU = Key.Optional(
        "edgeU", Coordinates.Direction, new Vector3D(0, 0, 2), "Edge from the corner along which u grows, object units; not along edgeV.");

    private static readonly Key<Vector3D> s_edgeV = Key.Optional("edgeV", Coordinates.Direction, new Vector3D(2, 0, 0), "Edge from the corner along which v grows, object units.");

    private static readonly Key<Point3D> s_boxCorner = Key.Optional("corner", Coordinates.Point, new Point3D(-1, -1, -1), "A corner, object space.");

    private static readonly Key<Point3D> s_opposite = Key.Optional(
        "opposite", Coordinates.Point, new Point3D(1, 1, 1), "The opposite corner, object space; different from the first in every coordinate.");

    /// <summary>An object, told by its shape.</summary>
    public static VariantFormat<SceneObject[]> Any { get; } = new(
        "shape",
        "A shape with a material at a place in the world.",
        [
            Shape("sphere", "A sphere.", [s_center, s_radius], fields => new Sphere(fields.Get(s_center), fields.Get(s_radius))),
            Shape("plane", "An infinite plane.", [s_point, s_normal], Plane),
            Shape("quad", "A parallelogram; by default the square [-1, 1] x [-1, 1] of the plane y = 0.", [s_corner, s_edgeU, s_edgeV], Quad),
            Shape("cylinder", "A cylinder around the y axis, without caps.", [s_middle, s_radius, s_height], Cylinder),
            Shape("disk", "A disk.", [s_center, s_normal, s_radius], fields => new Disk(fields.Get(s_center), fields.Get(s_normal), fields.Get(s_radius))),
            Shape("box", "A box along the axes.", [s_boxCorner, s_opposite], fields => new Box(fields.Get(s_boxCorner), fields.Get(s_opposite))),
        ]);

    private static ObjectFormat<SceneObject[]> Shape(string word, string description, Key[] keys, Func<Fields, Shape> make) => new(
        word,
        description,
        [s_name, .. keys, s_material, s_transform, s_castsShadows],
        fields => [Place(fields, make(fields), fields.Find(s_material) ?? s_white)],
        ("shape", word));

    private static SceneObject Place(Fields fields, Shape shape, Material material)
    {
        SceneObject placed = new(shape, material, fields.Find(s_transform))
        {
            Name = fields.Get(s_name), CastsShadows = fields.Get(s_castsShadows),
        };
        fields.Reading.SourceMap.Note(placed, fields.Node);
        return placed;
    }

    // Without point and normal the plane is y = 0 with the axes of the sheet: u along z, v along x.
    private static InfinitePlane Plane(Fields fields) => fields.Has(s_point) || fields.Has(s_normal)
        ? new InfinitePlane(fields.Get(s_point), fields.Get(s_normal))
        : new InfinitePlane();

    private static Quad Quad(Fields fields) => new(fields.Get(s_corner), fields.Get(s_edgeV), fields.Get(s_edgeU));

    private static Cylinder Cylinder(Fields fields) => new(fields.Get(s_middle), fields.Get(s_radius), fields.Get(s_height));
}
