namespace LabRaytracer;

/// <summary>Transforms of scene files: one step, or a list of steps applied from first to last.</summary>
internal static class TransformFormats
{
    /// <summary>What is wrong with a transform where only a rotation is allowed.</summary>
    public const string MoreThanRotation = "the transform does more than rotate";

    /// <summary>What is allowed there.</summary>
    public const string Rotations = "steps with rotateDegrees";

    private static readonly Key<Vector3D> s_translate = Key.Optional("translate", Coordinates.Vector, "Displacement [x, y, z].");

    private static readonly Key<Vector3D> s_scale = Key.Optional(
        "scale",
        new EitherFormat<Vector3D>(
            "a number other than 0, or three numbers [x, y, z], none 0",
            (NodeKind.Number, new MappedFormat<double, Vector3D>(NumberFormat.Any, factor => new Vector3D(factor, factor, factor))),
            (NodeKind.Array, Coordinates.Vector)),
        "Factor, or factors along the axes; none 0; negative ones mirror.");

    private static readonly Key<double> s_rotate = Key.Optional(
        "rotateDegrees", NumberFormat.Any, "Angle about the axis, degrees, counter-clockwise when the axis points at the viewer.");

    private static readonly Key<Vector3D> s_axis = Key.Optional("axis", Coordinates.Direction, Vector3D.UnitY, "Axis of the rotation, through the origin.");

    private static readonly Key<Matrix> s_matrix = Key.Optional(
        "matrix",
        new NumbersFormat<Matrix>(12, "12 numbers: three rows of four", numbers => new Matrix(numbers), matrix => matrix.Rows),
        "The 3 x 4 matrix, row after row: three numbers of the linear part, then one of the displacement, three times.");

    private static readonly ObjectFormat<Transform> s_step = new(
        "transformStep", "One of: translate, scale, rotateDegrees (with axis), matrix.", [s_translate, s_scale, s_rotate, s_axis, s_matrix], Step);

    /// <summary>One step or several.</summary>
    public static EitherFormat<Transform> Any { get; } = new(
        "a step { translate | scale | rotateDegrees, axis | matrix } or a list of steps",
        (NodeKind.Object, s_step),
        (NodeKind.Array, new MappedFormat<IReadOnlyList<Transform>, Transform>(
            new ListFormat<Transform>(s_step, "transform steps"),
            steps => steps.Aggregate(Transform.Identity, (all, next) => all.Then(next)))))
    { Name = "transform" };

    private static Transform? Step(Fields fields)
    {
        Key[] given = [.. new Key[] { s_translate, s_scale, s_rotate, s_matrix }.Where(fields.Has)];
        if (given.Length != 1 || (fields.Has(s_axis) && given[0] != s_rotate))
        {
            fields.Fail(given.Length > 1 ? given[1] : s_axis, "a step does one thing", "translate, scale, rotateDegrees with or without axis, matrix");
            return null;
        }

        return given[0] == s_translate ? Transform.Translation(fields.Get(s_translate))
            : given[0] == s_rotate ? Transform.Rotation(fields.Get(s_axis), fields.Get(s_rotate))
            : given[0] == s_scale ? fields.Make(s_scale, () => Transform.Scaling(fields.Get(s_scale)), "a factor is 0, or beyond what can be inverted", "factors other than 0")
            : fields.Make(s_matrix, () => Transform.FromRows(fields.Get(s_matrix).Rows), "the matrix is singular: it flattens space", "matrices that can be inverted");
    }

    private readonly record struct Matrix(double[] Rows);
}
