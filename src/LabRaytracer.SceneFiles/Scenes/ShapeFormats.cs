namespace LabRaytracer;

/// <summary>Shapes of scene files.</summary>
internal static class ShapeFormats
{
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

    private static readonly Key<Point3D> s_a = Key.Required("a", Coordinates.Point, "First vertex, object space.");

    private static readonly Key<Point3D> s_b = Key.Required("b", Coordinates.Point, "Second vertex, object space.");

    private static readonly Key<Point3D> s_c = Key.Required("c", Coordinates.Point, "Third vertex, object space; not on one line with the others.");

    private static readonly Key<IReadOnlyList<Vector3D>> s_normals = Key.Optional(
        "normals", new ListFormat<Vector3D>(Coordinates.Direction, "three directions"), "Normals at a, b and c for smooth shading, object space. Default: flat.");

    private static readonly Key<IReadOnlyList<TextureCoordinate>> s_uvs = Key.Optional(
        "uvs", new ListFormat<TextureCoordinate>(Coordinates.Uv, "three pairs [u, v]"), "Texture coordinates of a, b and c. Default: [0, 0], [1, 0], [0, 1].");

    private static readonly Key<double> s_ringRadius = Key.Optional("ringRadius", NumberFormat.Positive, 1, "Distance of the middle of the tube from the centre, object units.");

    private static readonly Key<double> s_tubeRadius = Key.Optional("tubeRadius", NumberFormat.Positive, 0.25, "Radius of the tube, object units; below that of the ring.");

    private static readonly Key<double> s_baseRadius = Key.Optional("radius", NumberFormat.Positive, 1, "Radius of the base, object units.");

    private static readonly Key<double> s_coneHeight = Key.Optional("height", NumberFormat.Positive, 2, "Distance of the apex from the base, object units.");

    private static readonly Key<ConeCaps> s_caps = Key.Optional("caps", ChoiceFormat.Of<ConeCaps>(), ConeCaps.Closed, "Whether the cone has a base.");

    /// <summary>The shapes that are written as numbers.</summary>
    public static IReadOnlyList<ShapeFormat> All { get; } =
    [
        new("sphere", "A sphere.", [s_center, s_radius], fields => new Sphere(fields.Get(s_center), fields.Get(s_radius))),
        new("plane", "An infinite plane.", [s_point, s_normal], Plane),
        new("quad", "A parallelogram; by default the square [-1, 1] x [-1, 1] of the plane y = 0.", [s_corner, s_edgeU, s_edgeV], Quad),
        new("cylinder", "A cylinder around the y axis, without caps.", [s_middle, s_radius, s_height], Cylinder),
        new("disk", "A disk.", [s_center, s_normal, s_radius], fields => new Disk(fields.Get(s_center), fields.Get(s_normal), fields.Get(s_radius))),
        new("box", "A box along the axes.", [s_boxCorner, s_opposite], Box),
        new("triangle", "A triangle.", [s_a, s_b, s_c, s_normals, s_uvs], Triangle),
        new("torus", "A torus around the y axis.", [s_center, s_ringRadius, s_tubeRadius], Torus),
        new("cone", "A cone around the y axis, the apex on top.", [s_middle, s_baseRadius, s_coneHeight, s_caps], Cone),
    ];

    // Without point and normal the plane is y = 0 with the axes of the sheet: u along z, v along x.
    private static InfinitePlane Plane(Fields fields) => fields.Has(s_point) || fields.Has(s_normal)
        ? new InfinitePlane(fields.Get(s_point), fields.Get(s_normal))
        : new InfinitePlane();

    private static Quad? Quad(Fields fields) => fields.Make(
        s_edgeU, () => new Quad(fields.Get(s_corner), fields.Get(s_edgeV), fields.Get(s_edgeU)), "the edges span no area", "edges that are not parallel");

    private static Box? Box(Fields fields) => fields.Make(
        s_opposite, () => new Box(fields.Get(s_boxCorner), fields.Get(s_opposite)), "the box is flat or too large", "corners that differ in every coordinate");

    private static Cylinder Cylinder(Fields fields) => new(fields.Get(s_middle), fields.Get(s_radius), fields.Get(s_height));

    private static Torus? Torus(Fields fields) => fields.Make(
        s_tubeRadius,
        () => new Torus(fields.Get(s_center), fields.Get(s_ringRadius), fields.Get(s_tubeRadius)),
        "the tube is not thinner than the ring",
        "a tubeRadius below the ringRadius");

    private static Cone Cone(Fields fields) => new(fields.Get(s_middle), fields.Get(s_baseRadius), fields.Get(s_coneHeight), fields.Get(s_caps));

    private static Triangle? Triangle(Fields fields)
    {
        Check(fields, s_normals);
        Check(fields, s_uvs);
        Triangle? flat = fields.Make(
            s_c, () => new Triangle(fields.Get(s_a), fields.Get(s_b), fields.Get(s_c)), "the vertices lie on one line", "three points that span an area");
        return flat is null || fields.Failed ? null : new Triangle(flat.A, flat.B, flat.C)
        {
            VertexNormals = fields.Find(s_normals) ?? flat.VertexNormals,
            VertexCoordinates = fields.Find(s_uvs) ?? flat.VertexCoordinates,
        };
    }

    private static void Check<T>(Fields fields, Key<IReadOnlyList<T>> key)
    {
        if (fields.Find(key) is { Count: not 3 } list)
        {
            fields.Fail(key, $"a list of {list.Count}", "one for each of the three vertices");
        }
    }
}

/// <summary>A shape of scene files.</summary>
/// <param name="Word">Value of the key "shape".</param>
/// <param name="Description">One sentence for the schema.</param>
/// <param name="Keys">Its keys.</param>
/// <param name="Make">Makes it.</param>
internal sealed record ShapeFormat(string Word, string Description, Key[] Keys, Func<Fields, Shape?> Make);
