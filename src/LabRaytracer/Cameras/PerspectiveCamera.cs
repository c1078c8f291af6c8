namespace LabRaytracer;

/// <summary>A pinhole camera (Polish: kamera perspektywiczna).</summary>
/// <remarks>
/// Immutable, thread safe. With f = normalize(target - eye), r = normalize(f x up), u = r x f, the ray through (x, y) has direction
/// f + r (2 x / width - 1) tan(fov / 2) width / height + u (1 - 2 y / height) tan(fov / 2), normalised.
/// </remarks>
public sealed class PerspectiveCamera : Camera, IWideCamera
{
    private readonly CameraFrame _frame;
    private readonly double _halfHeight;

    /// <summary>Creates a pinhole camera.</summary>
    /// <param name="eye">Where the camera stands, world space; finite.</param>
    /// <param name="target">Where it looks, world space; finite, not the eye.</param>
    /// <param name="fieldOfViewDegrees">Vertical angle of view, degrees, (0, 180).</param>
    /// <param name="up">What is up on the picture, world space; null for +Y. Not along the line of sight.</param>
    /// <exception cref="ArgumentOutOfRangeException">An argument is outside its range.</exception>
    public PerspectiveCamera(Point3D eye, Point3D target, double fieldOfViewDegrees, Vector3D? up = null)
    {
        if (!(fieldOfViewDegrees is > 0 and < 180))
        {
            throw new ArgumentOutOfRangeException(nameof(fieldOfViewDegrees), fieldOfViewDegrees, "The field of view must be in (0, 180) degrees.");
        }

        _frame = CameraFrame.LookAt(eye, target, up ?? Vector3D.UnitY);
        (double sin, double cos) = Elementary.SinCosDegrees(fieldOfViewDegrees / 2);
        _halfHeight = sin / cos;
        FieldOfViewDegrees = fieldOfViewDegrees;
        Target = target;
    }

    /// <summary>Where the camera stands, world space.</summary>
    public Point3D Eye => _frame.Eye;

    /// <summary>Where it looks, world space.</summary>
    public Point3D Target { get; }

    /// <summary>Vertical angle of view, degrees, (0, 180).</summary>
    public double FieldOfViewDegrees { get; }

    /// <summary>Position and axes.</summary>
    internal CameraFrame Frame => _frame;

    /// <inheritdoc/>
    public override Ray RayAt(double x, double y, int width, int height) => ScalarCamera.RayAt(this, x, y, width, height);

    /// <inheritdoc/>
    public override RayDifferential DifferentialAt(double x, double y, int width, int height) => ScalarCamera.DifferentialAt(this, x, y, width, height);

    bool IWideCamera.HasOneOrigin => true;

    unsafe void IWideCamera.Rays<R>(R* x, R* y, in RayColumns<R> rays, int packets, int width, int height) => Aim(x, y, rays, packets, width, height);

    /// <remarks>Before they are normalised, directions are linear in x and y: the corners of the rectangle bound them. Their length is that of (1, aside, above).</remarks>
    RayBounds? IWideCamera.Bounds(double left, double right, double top, double bottom, int width, int height)
    {
        double scale = _halfHeight / height;
        double aside = Math.FusedMultiplyAdd(2, left, -width) * scale, farAside = Math.FusedMultiplyAdd(2, right, -width) * scale;
        double above = Math.FusedMultiplyAdd(-2, bottom, height) * scale, farAbove = Math.FusedMultiplyAdd(-2, top, height) * scale;
        (double leastX, double largestX) = Range(_frame.Forward.X, _frame.Right.X, _frame.Up.X);
        (double leastY, double largestY) = Range(_frame.Forward.Y, _frame.Right.Y, _frame.Up.Y);
        (double leastZ, double largestZ) = Range(_frame.Forward.Z, _frame.Right.Z, _frame.Up.Z);
        double nearAside = Math.Max(0, Math.Max(aside, -farAside)), nearAbove = Math.Max(0, Math.Max(above, -farAbove));
        return new RayBounds(
            Eye, Eye, new Vector3D(leastX, leastY, leastZ), new Vector3D(largestX, largestY, largestZ),
            Math.Sqrt(1 + (nearAside * nearAside) + (nearAbove * nearAbove)), double.PositiveInfinity)
        {
            Apex = Eye, Sense = 1,
        };

        (double Least, double Largest) Range(double forward, double right, double up)
        {
            double a = aside * right, b = farAside * right, c = above * up, d = farAbove * up;
            return (forward + Math.Min(a, b) + Math.Min(c, d), forward + Math.Max(a, b) + Math.Max(c, d));
        }
    }

    /// <summary>The same, not virtual: ahead-of-time compilers do not see through virtual generic methods.</summary>
    internal unsafe void Aim<R>(R* x, R* y, in RayColumns<R> rays, int packets, int width, int height)
        where R : unmanaged, IReal<R>
    {
        R across = R.Of(width), down = R.Of(height), scale = R.Of(_halfHeight / height);
        for (int packet = 0; packet < packets; packet++)
        {
            R aside = R.Fma(R.Of(2), x[packet], -across) * scale;
            R above = R.Fma(R.Of(-2), y[packet], down) * scale;
            R dx = R.Fma(aside, R.Of(_frame.Right.X), R.Fma(above, R.Of(_frame.Up.X), R.Of(_frame.Forward.X)));
            R dy = R.Fma(aside, R.Of(_frame.Right.Y), R.Fma(above, R.Of(_frame.Up.Y), R.Of(_frame.Forward.Y)));
            R dz = R.Fma(aside, R.Of(_frame.Right.Z), R.Fma(above, R.Of(_frame.Up.Z), R.Of(_frame.Forward.Z)));
            R toUnit = R.Of(1) / R.Sqrt(Lane.Dot(dx, dy, dz, dx, dy, dz));
            rays.DirectionX[packet] = dx * toUnit;
            rays.DirectionY[packet] = dy * toUnit;
            rays.DirectionZ[packet] = dz * toUnit;
        }

        if (rays.OriginX != null)
        {
            new Span<R>(rays.OriginX, packets).Fill(R.Of(Eye.X));
            new Span<R>(rays.OriginY, packets).Fill(R.Of(Eye.Y));
            new Span<R>(rays.OriginZ, packets).Fill(R.Of(Eye.Z));
        }
    }

    unsafe void IWideCamera.Differentials<T>(
        in VectorColumns<T> directions, in DifferentialColumns<T> differentials, int packets, int width, int height, double spacing) =>
        Steps(height, spacing).Write(directions, differentials, packets);

    /// <summary>How rays change from one sample to the next.</summary>
    /// <param name="height">Height of the whole picture, pixels.</param>
    /// <param name="spacing">Distance of samples, pixels.</param>
    internal PinholeSteps Steps(int height, double spacing)
    {
        double step = 2 * _halfHeight / height * spacing;
        return new PinholeSteps(_frame.Forward, _frame.Right * step, _frame.Up * -step);
    }
}
