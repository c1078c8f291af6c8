namespace LabRaytracer;

/// <summary>A camera whose rays are parallel (Polish: kamera ortogonalna): distant things are as large as near ones.</summary>
/// <remarks>
/// Immutable, thread safe. With f = normalize(target - eye), r = normalize(f x up), u = r x f, the ray through (x, y) has direction f and starts at
/// eye + r (2 x / width - 1) height' / 2 width / height + u (1 - 2 y / height) height' / 2, height' being the view's height in scene units.
/// What lies behind the plane through the eye is not seen.
/// </remarks>
public sealed class OrthographicCamera : Camera, IWideCamera
{
    private readonly CameraFrame _frame;

    /// <summary>Creates a camera with parallel rays.</summary>
    /// <param name="eye">Middle of the view, world space; finite.</param>
    /// <param name="target">Where it looks, world space; finite, not the eye.</param>
    /// <param name="height">Height of what the picture shows, scene units; finite, above 0.</param>
    /// <param name="up">What is up on the picture, world space; null for +Y. Not along the line of sight.</param>
    /// <exception cref="ArgumentOutOfRangeException">An argument is outside its range.</exception>
    public OrthographicCamera(Point3D eye, Point3D target, double height, Vector3D? up = null)
    {
        if (!(height > 0) || !double.IsFinite(height))
        {
            throw new ArgumentOutOfRangeException(nameof(height), height, "The height of an orthographic view must be finite and above 0, in scene units.");
        }

        _frame = CameraFrame.LookAt(eye, target, up ?? Vector3D.UnitY);
        Height = height;
        Target = target;
    }

    /// <summary>Middle of the view, world space.</summary>
    public Point3D Eye => _frame.Eye;

    /// <summary>Where it looks, world space.</summary>
    public Point3D Target { get; }

    /// <summary>Height of what the picture shows, scene units.</summary>
    public double Height { get; }

    /// <inheritdoc/>
    public override Ray RayAt(double x, double y, int width, int height) => ScalarCamera.RayAt(this, x, y, width, height);

    /// <inheritdoc/>
    public override RayDifferential DifferentialAt(double x, double y, int width, int height) => ScalarCamera.DifferentialAt(this, x, y, width, height);

    unsafe void IWideCamera.Rays<R>(R* x, R* y, in RayColumns<R> rays, int packets, int width, int height)
    {
        R across = R.Of(width), down = R.Of(height), scale = R.Of(Height / height / 2);
        for (int packet = 0; packet < packets; packet++)
        {
            R aside = R.Fma(R.Of(2), x[packet], -across) * scale;
            R above = R.Fma(R.Of(-2), y[packet], down) * scale;
            rays.OriginX[packet] = R.Fma(aside, R.Of(_frame.Right.X), R.Fma(above, R.Of(_frame.Up.X), R.Of(Eye.X)));
            rays.OriginY[packet] = R.Fma(aside, R.Of(_frame.Right.Y), R.Fma(above, R.Of(_frame.Up.Y), R.Of(Eye.Y)));
            rays.OriginZ[packet] = R.Fma(aside, R.Of(_frame.Right.Z), R.Fma(above, R.Of(_frame.Up.Z), R.Of(Eye.Z)));
            rays.DirectionX[packet] = R.Of(_frame.Forward.X);
            rays.DirectionY[packet] = R.Of(_frame.Forward.Y);
            rays.DirectionZ[packet] = R.Of(_frame.Forward.Z);
        }
    }

    void IWideCamera.Differentials<T>(
        in VectorColumns<T> directions, in DifferentialColumns<T> differentials, int packets, int width, int height, double spacing)
    {
        Vector3D right = _frame.Right * (Height / height * spacing), down = _frame.Up * (-Height / height * spacing);
        for (int packet = 0; packet < packets; packet++)
        {
            differentials.OriginDx.Store(packet, T.Of(right.X), T.Of(right.Y), T.Of(right.Z));
            differentials.OriginDy.Store(packet, T.Of(down.X), T.Of(down.Y), T.Of(down.Z));
            differentials.DirectionDx.Store(packet, T.Zero, T.Zero, T.Zero);
            differentials.DirectionDy.Store(packet, T.Zero, T.Zero, T.Zero);
        }
    }
}
