namespace LabRaytracer;

/// <summary>An invertible affine map between object space and world space; both directions are stored.</summary>
/// <remarks>
/// Immutable, thread safe. A point p maps to <c>A p + b</c>. Normals map with the inverse transpose.
/// Compose with <see cref="Then"/>: <c>a.Then(b)</c> applies <c>a</c> first.
/// </remarks>
public sealed class Transform
{
    private readonly double[] _worldFromObject;
    private readonly double[] _objectFromWorld;

    private Transform(double[] worldFromObject, double[] objectFromWorld)
    {
        _worldFromObject = worldFromObject;
        _objectFromWorld = objectFromWorld;
        IsIdentity = worldFromObject.AsSpan().SequenceEqual([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]);
    }

    /// <summary>The map that changes nothing.</summary>
    public static Transform Identity { get; } = new([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0]);

    /// <summary>Tells whether this map is exactly the identity.</summary>
    public bool IsIdentity { get; }

    /// <summary>Tells whether this map is a rotation about an axis through the origin, up to rounding: lengths and handedness stay, nothing is moved.</summary>
    internal bool IsRotation
    {
        get
        {
            double[] m = _worldFromObject;
            Vector3D x = new(m[0], m[1], m[2]), y = new(m[4], m[5], m[6]), z = new(m[8], m[9], m[10]);
            return m[3] == 0 && m[7] == 0 && m[11] == 0
                && Math.Abs(x.Length - 1) < 1e-9 && Math.Abs(y.Length - 1) < 1e-9 && (Vector3D.Cross(x, y) - z).Length < 1e-9;
        }
    }

    /// <summary>The 12 numbers of the 3x4 matrix object to world, row after row (three rows of A, each followed by its b).</summary>
    public ReadOnlySpan<double> WorldFromObjectRows => _worldFromObject;

    /// <summary>The 12 numbers of the 3x4 matrix world to object, row after row.</summary>
    public ReadOnlySpan<double> ObjectFromWorldRows => _objectFromWorld;

    /// <summary>A map that moves every point by the same vector.</summary>
    /// <param name="offset">Displacement, world units; finite.</param>
    /// <exception cref="ArgumentException">A component is NaN or infinite.</exception>
    public static Transform Translation(Vector3D offset) =>
        FromRows([1, 0, 0, offset.X, 0, 1, 0, offset.Y, 0, 0, 1, offset.Z]);

    /// <summary>A map that scales along the three axes.</summary>
    /// <param name="factors">Factors along X, Y, Z; finite, none 0; negative ones mirror.</param>
    /// <exception cref="ArgumentException">A factor is 0, NaN or infinite.</exception>
    public static Transform Scaling(Vector3D factors) =>
        FromRows([factors.X, 0, 0, 0, 0, factors.Y, 0, 0, 0, 0, factors.Z, 0]);

    /// <summary>A rotation about an axis through the origin, counter-clockwise when the axis points at the viewer.</summary>
    /// <param name="axis">Axis; any finite length above 0.</param>
    /// <param name="degrees">Angle in degrees; finite. Multiples of 90 degrees are exact.</param>
    /// <exception cref="ArgumentException">The axis has no direction, or the angle is not finite.</exception>
    public static Transform Rotation(Vector3D axis, double degrees)
    {
        if (!axis.IsFinite || axis == Vector3D.Zero || !double.IsFinite(degrees))
        {
            throw new ArgumentException($"A rotation needs an axis with a direction and a finite angle; got axis {axis}, {degrees} degrees.");
        }

        Vector3D n = axis.Normalized();
        (double sin, double cos) = Elementary.SinCosDegrees(degrees);
        double k = 1 - cos;
        return FromRows(
        [
            (k * n.X * n.X) + cos, (k * n.X * n.Y) - (sin * n.Z), (k * n.X * n.Z) + (sin * n.Y), 0,
            (k * n.X * n.Y) + (sin * n.Z), (k * n.Y * n.Y) + cos, (k * n.Y * n.Z) - (sin * n.X), 0,
            (k * n.X * n.Z) - (sin * n.Y), (k * n.Y * n.Z) + (sin * n.X), (k * n.Z * n.Z) + cos, 0,
        ]);
    }

    /// <summary>A map from its 3x4 matrix object to world.</summary>
    /// <param name="rows">12 finite numbers, row after row: three numbers of A, then one of b, three times.</param>
    /// <exception cref="ArgumentException">Not 12 numbers, one is not finite, or the matrix is singular.</exception>
    public static Transform FromRows(ReadOnlySpan<double> rows)
    {
        if (rows.Length != 12)
        {
            throw new ArgumentException($"A transform has 12 numbers (3 rows of 4); got {rows.Length}.", nameof(rows));
        }

        foreach (double number in rows)
        {
            if (!double.IsFinite(number))
            {
                throw new ArgumentException($"A transform needs finite numbers; got {number}.", nameof(rows));
            }
        }

        return new Transform(rows.ToArray(), Inverse(rows));
    }

    /// <summary>The map that applies this one first, then <paramref name="next"/>.</summary>
    public Transform Then(Transform next)
    {
        ArgumentNullException.ThrowIfNull(next);
        return IsIdentity ? next
            : next.IsIdentity ? this
            : new Transform(Product(next._worldFromObject, _worldFromObject), Product(_objectFromWorld, next._objectFromWorld));
    }

    /// <summary>A point in world space from a point in object space.</summary>
    public Point3D WorldFromObject(Point3D objectPoint) => Apply(_worldFromObject, objectPoint);

    /// <summary>A vector in world space from a vector in object space.</summary>
    public Vector3D WorldFromObject(Vector3D objectVector) => Apply(_worldFromObject, objectVector);

    /// <summary>A point in object space from a point in world space.</summary>
    public Point3D ObjectFromWorld(Point3D worldPoint) => Apply(_objectFromWorld, worldPoint);

    /// <summary>A vector in object space from a vector in world space.</summary>
    public Vector3D ObjectFromWorld(Vector3D worldVector) => Apply(_objectFromWorld, worldVector);

    /// <summary>A ray in object space; its direction keeps the ray parameter: the same t names the same point.</summary>
    public Ray ObjectFromWorld(in Ray worldRay) => new(ObjectFromWorld(worldRay.Origin), ObjectFromWorld(worldRay.Direction));

    /// <summary>A world-space normal (not of unit length) from an object-space one: product with the inverse transpose.</summary>
    public Vector3D WorldNormalFromObject(Vector3D objectNormal)
    {
        double[] m = _objectFromWorld;
        return new Vector3D(
            (m[0] * objectNormal.X) + (m[4] * objectNormal.Y) + (m[8] * objectNormal.Z),
            (m[1] * objectNormal.X) + (m[5] * objectNormal.Y) + (m[9] * objectNormal.Z),
            (m[2] * objectNormal.X) + (m[6] * objectNormal.Y) + (m[10] * objectNormal.Z));
    }

    private static Point3D Apply(double[] m, Point3D p) => new(
        Row(m, 0, p.X, p.Y, p.Z) + m[3],
        Row(m, 4, p.X, p.Y, p.Z) + m[7],
        Row(m, 8, p.X, p.Y, p.Z) + m[11]);

    private static Vector3D Apply(double[] m, Vector3D v) => new(
        Row(m, 0, v.X, v.Y, v.Z), Row(m, 4, v.X, v.Y, v.Z), Row(m, 8, v.X, v.Y, v.Z));

    private static double Row(double[] m, int at, double x, double y, double z) =>
        Math.FusedMultiplyAdd(m[at], x, Math.FusedMultiplyAdd(m[at + 1], y, m[at + 2] * z));

    private static double[] Product(double[] a, double[] b)
    {
        double[] product = new double[12];
        for (int row = 0; row < 12; row += 4)
        {
            for (int column = 0; column < 4; column++)
            {
                product[row + column] = (a[row] * b[column]) + (a[row + 1] * b[column + 4]) + (a[row + 2] * b[column + 8])
                    + (column == 3 ? a[row + 3] : 0);
            }
        }

        return product;
    }

    /// <summary>Inverse by cofactors; the columns' cross products are Kahan-accurate.</summary>
    private static double[] Inverse(ReadOnlySpan<double> m)
    {
        Vector3D column0 = new(m[0], m[4], m[8]);
        Vector3D column1 = new(m[1], m[5], m[9]);
        Vector3D column2 = new(m[2], m[6], m[10]);
        double size = column0.Length * column1.Length * column2.Length;
        Vector3D row0 = Vector3D.Cross(column1, column2);
        double determinant = Vector3D.Dot(column0, row0);
        if (!(Math.Abs(determinant) > 1e-14 * size) || !double.IsFinite(determinant))
        {
            throw new ArgumentException("The transform is singular: it flattens space, so that it cannot be inverted. Every scale factor must differ from 0.");
        }

        row0 /= determinant;
        Vector3D row1 = Vector3D.Cross(column2, column0) / determinant;
        Vector3D row2 = Vector3D.Cross(column0, column1) / determinant;
        Vector3D offset = new(m[3], m[7], m[11]);
        return
        [
            row0.X, row0.Y, row0.Z, -Vector3D.Dot(row0, offset),
            row1.X, row1.Y, row1.Z, -Vector3D.Dot(row1, offset),
            row2.X, row2.Y, row2.Z, -Vector3D.Dot(row2, offset),
        ];
    }
}
