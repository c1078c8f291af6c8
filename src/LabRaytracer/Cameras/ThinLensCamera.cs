namespace LabRaytracer;

/// <summary>A camera with a lens (Polish: kamera z soczewką): sharp at one distance, blurred before and behind it (depth of field).</summary>
/// <remarks>
/// <para>Immutable, thread safe. Every point of the lens, a disk of the given radius around the eye across the line of sight, sends its ray to the point of the plane of focus
/// that a <see cref="PerspectiveCamera"/> of the same view sees there; the mean over the lens is the pixel (Potmesil and Chakravarty 1981). A point at the distance z along the line of
/// sight is spread over a disk whose radius on the plane of focus at distance F is r |1 - F / z|.</para>
/// <para>One sample a pixel shows noise instead of blur: take 16 or more. Squares of samples become disks by the map of Shirley and Chiu (1997).
/// A lens of radius 0 is the pinhole camera, bit for bit.</para>
/// </remarks>
public sealed class ThinLensCamera : Camera, IWideLensCamera
{
    private readonly PerspectiveCamera _pinhole;
    private readonly CameraFrame _frame;

    /// <summary>Creates a camera with a lens.</summary>
    /// <param name="pinhole">Where the camera stands, where it looks, its angle of view.</param>
    /// <param name="lensRadius">Radius of the lens, scene units; finite, at least 0.</param>
    /// <param name="focusDistance">Distance of the plane of focus along the line of sight, scene units; finite, above 0. Null: the plane goes through the camera's target.</param>
    /// <exception cref="ArgumentOutOfRangeException">A length is outside its range.</exception>
    public ThinLensCamera(PerspectiveCamera pinhole, double lensRadius, double? focusDistance = null)
    {
        ArgumentNullException.ThrowIfNull(pinhole);
        if (!(lensRadius >= 0) || !double.IsFinite(lensRadius))
        {
            throw new ArgumentOutOfRangeException(nameof(lensRadius), lensRadius, "The radius of a lens must be finite and at least 0, in scene units.");
        }

        _pinhole = pinhole;
        _frame = pinhole.Frame;
        FocusDistance = focusDistance ?? Vector3D.Dot(pinhole.Target - pinhole.Eye, _frame.Forward);
        if (!(FocusDistance > 0) || !double.IsFinite(FocusDistance))
        {
            throw new ArgumentOutOfRangeException(nameof(focusDistance), focusDistance, "The distance of the plane of focus must be finite and above 0, in scene units.");
        }

        LensRadius = lensRadius;
    }

    /// <summary>The camera that sees the same through a hole: where this one stands, where it looks, its angle of view.</summary>
    public PerspectiveCamera Pinhole => _pinhole;

    /// <summary>Radius of the lens, scene units, at least 0.</summary>
    public double LensRadius { get; }

    /// <summary>Distance of the plane of focus along the line of sight, scene units, above 0.</summary>
    public double FocusDistance { get; }

    /// <inheritdoc/>
    public override bool HasLens => LensRadius > 0;

    /// <summary>The ray through the middle of the lens.</summary>
    public override Ray RayAt(double x, double y, int width, int height) => _pinhole.RayAt(x, y, width, height);

    /// <inheritdoc/>
    public override Ray RayAt(double x, double y, SquarePoint lens, int width, int height) => HasLens
        ? ScalarCamera.Spread(this, RayAt(x, y, width, height), lens)
        : RayAt(x, y, width, height);

    /// <inheritdoc/>
    public override RayDifferential DifferentialAt(double x, double y, int width, int height) => _pinhole.DifferentialAt(x, y, width, height);

    unsafe void IWideCamera.Rays<R>(R* x, R* y, in RayColumns<R> rays, int packets, int width, int height) => _pinhole.Aim(x, y, rays, packets, width, height);

    unsafe void IWideLensCamera.Spread<R>(R* s, R* t, in RayColumns<R> rays, int packets)
    {
        R radius = R.Of(LensRadius), focus = R.Of(FocusDistance);
        for (int packet = 0; packet < packets; packet++)
        {
            (R a, R b) = SquareDisk.At(s[packet], t[packet]);
            a *= radius;
            b *= radius;
            R ox = R.Fma(a, R.Of(_frame.Right.X), b * R.Of(_frame.Up.X));
            R oy = R.Fma(a, R.Of(_frame.Right.Y), b * R.Of(_frame.Up.Y));
            R oz = R.Fma(a, R.Of(_frame.Right.Z), b * R.Of(_frame.Up.Z));
            R dx = rays.DirectionX[packet], dy = rays.DirectionY[packet], dz = rays.DirectionZ[packet];
            R reach = focus / Lane.Dot(dx, dy, dz, R.Of(_frame.Forward.X), R.Of(_frame.Forward.Y), R.Of(_frame.Forward.Z));
            dx = R.Fma(dx, reach, -ox);
            dy = R.Fma(dy, reach, -oy);
            dz = R.Fma(dz, reach, -oz);
            R toUnit = R.Of(1) / R.Sqrt(Lane.Dot(dx, dy, dz, dx, dy, dz));
            rays.DirectionX[packet] = dx * toUnit;
            rays.DirectionY[packet] = dy * toUnit;
            rays.DirectionZ[packet] = dz * toUnit;
            rays.OriginX[packet] += ox;
            rays.OriginY[packet] += oy;
            rays.OriginZ[packet] += oz;
        }
    }

    /// <remarks>The pinhole's formula holds for every point of the lens: the ray goes to a point of the plane of focus, at the distance focus / (d . f).</remarks>
    void IWideCamera.Differentials<T>(
        in VectorColumns<T> directions, in DifferentialColumns<T> differentials, int packets, int width, int height, double spacing) =>
        ((IWideCamera)_pinhole).Differentials(directions, differentials, packets, width, height, spacing);
}
