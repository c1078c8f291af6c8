namespace LabRaytracer;

/// <summary>A direction or displacement in right-handed, y-up space, in double precision.</summary>
/// <param name="X">Component along +X, scene units.</param>
/// <param name="Y">Component along +Y (up), scene units.</param>
/// <param name="Z">Component along +Z, scene units.</param>
/// <remarks>Immutable, thread safe. The default value is the zero vector.</remarks>
public readonly record struct Vector3D(double X, double Y, double Z)
{
    /// <summary>The vector (0, 0, 0).</summary>
    public static Vector3D Zero => default;

    /// <summary>The unit vector (1, 0, 0).</summary>
    public static Vector3D UnitX => new(1, 0, 0);

    /// <summary>The unit vector (0, 1, 0), up.</summary>
    public static Vector3D UnitY => new(0, 1, 0);

    /// <summary>The unit vector (0, 0, 1).</summary>
    public static Vector3D UnitZ => new(0, 0, 1);

    /// <summary>Squared length, scene units squared, [0, +inf].</summary>
    public double LengthSquared => Dot(this, this);

    /// <summary>Length, scene units, [0, +inf]; neither overflows nor underflows when the length itself is representable.</summary>
    public double Length
    {
        get
        {
            double largest = Math.Max(Math.Abs(X), Math.Max(Math.Abs(Y), Math.Abs(Z)));
            if (largest == 0 || !double.IsFinite(largest))
            {
                return largest;
            }

            double scale = Math.ScaleB(1, Math.Clamp(-Math.ILogB(largest), -1022, 1022));
            return Math.Sqrt((this * scale).LengthSquared) / scale;
        }
    }

    /// <summary>Tells whether no component is NaN or infinite.</summary>
    public bool IsFinite => double.IsFinite(X) && double.IsFinite(Y) && double.IsFinite(Z);

    /// <summary>Sum of two vectors.</summary>
    public static Vector3D operator +(Vector3D a, Vector3D b) => new(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

    /// <summary>Difference of two vectors.</summary>
    public static Vector3D operator -(Vector3D a, Vector3D b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>The opposite vector.</summary>
    public static Vector3D operator -(Vector3D a) => new(-a.X, -a.Y, -a.Z);

    /// <summary>The vector scaled by a factor.</summary>
    public static Vector3D operator *(Vector3D a, double factor) => new(a.X * factor, a.Y * factor, a.Z * factor);

    /// <summary>The vector scaled by a factor.</summary>
    public static Vector3D operator *(double factor, Vector3D a) => a * factor;

    /// <summary>The vector divided by a number.</summary>
    public static Vector3D operator /(Vector3D a, double divisor) => new(a.X / divisor, a.Y / divisor, a.Z / divisor);

    /// <summary>Scalar product; fused multiply-add, error at most 2 rounding errors of the largest partial sum.</summary>
    public static double Dot(Vector3D a, Vector3D b) =>
        Math.FusedMultiplyAdd(a.X, b.X, Math.FusedMultiplyAdd(a.Y, b.Y, a.Z * b.Z));

    /// <summary>Right-handed vector product: perpendicular to both, <c>UnitX x UnitY = UnitZ</c>.</summary>
    /// <remarks>Each component is a difference of products by Kahan's fused form: relative error at most 1.5 ulp, no cancellation.</remarks>
    public static Vector3D Cross(Vector3D a, Vector3D b) => new(
        DifferenceOfProducts(a.Y, b.Z, a.Z, b.Y),
        DifferenceOfProducts(a.Z, b.X, a.X, b.Z),
        DifferenceOfProducts(a.X, b.Y, a.Y, b.X));

    /// <summary>The vector of length 1 in the same direction.</summary>
    /// <returns>A vector whose length is 1 within 2 ulp.</returns>
    /// <exception cref="InvalidOperationException">The vector is zero or not finite: it has no direction.</exception>
    public Vector3D Normalized()
    {
        double length = Length;
        if (!(length > 0) || !double.IsFinite(length))
        {
            throw new InvalidOperationException($"The vector {this} has no direction: its length must be finite and above 0.");
        }

        return this / length;
    }

    private static double DifferenceOfProducts(double a, double b, double c, double d)
    {
        double cd = c * d;
        double error = Math.FusedMultiplyAdd(-c, d, cd);
        return Math.FusedMultiplyAdd(a, b, -cd) + error;
    }
}
