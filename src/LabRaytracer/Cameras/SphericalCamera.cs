namespace LabRaytracer;

/// <summary>A camera that sees everything around a point (Polish: kamera sferyczna): its picture is a lat-long panorama of aspect 2:1.</summary>
/// <remarks>
/// Immutable, thread safe. The pixel position (x, y) looks in the direction whose <see cref="SphericalMapping"/> is u = x / width, v = 1 - y / height:
/// (sin theta sin phi, cos theta, sin theta cos phi) with phi = 2 pi x / width, theta = pi y / height (lab sheet IV, section 1.1.3). From the centre of
/// a textured sphere it gives the sphere's own picture back.
/// </remarks>
public sealed class SphericalCamera : Camera, IWideCamera
{
    /// <summary>Creates a panorama camera.</summary>
    /// <param name="eye">Where the camera stands, world space; finite.</param>
    /// <exception cref="ArgumentOutOfRangeException">The point is not finite.</exception>
    public SphericalCamera(Point3D eye) => Eye = eye.IsFinite
        ? eye
        : throw new ArgumentOutOfRangeException(nameof(eye), eye, "The position of a camera needs finite coordinates.");

    /// <summary>Where the camera stands, world space.</summary>
    public Point3D Eye { get; }

    /// <inheritdoc/>
    public override Ray RayAt(double x, double y, int width, int height) => ScalarCamera.RayAt(this, x, y, width, height);

    /// <inheritdoc/>
    public override RayDifferential DifferentialAt(double x, double y, int width, int height) => ScalarCamera.DifferentialAt(this, x, y, width, height);

    unsafe void IWideCamera.Rays<R>(R* x, R* y, in RayColumns<R> rays, int packets, int width, int height)
    {
        R turn = R.Of(width), twoTurns = R.Of(2.0 * height);
        for (int packet = 0; packet < packets; packet++)
        {
            (R sinPhi, R cosPhi) = Elementary.SinCosTurns(x[packet] / turn);
            (R sinTheta, R cosTheta) = Elementary.SinCosTurns(y[packet] / twoTurns);
            rays.OriginX[packet] = R.Of(Eye.X);
            rays.OriginY[packet] = R.Of(Eye.Y);
            rays.OriginZ[packet] = R.Of(Eye.Z);
            rays.DirectionX[packet] = sinTheta * sinPhi;
            rays.DirectionY[packet] = cosTheta;
            rays.DirectionZ[packet] = sinTheta * cosPhi;
        }
    }

    /// <remarks>d(phi) of the direction (sin theta sin phi, cos theta, sin theta cos phi) is (z, 0, -x); d(theta) is (y x, -s², y z) / s with s = sin theta.</remarks>
    unsafe void IWideCamera.Differentials<T>(
        in VectorColumns<T> directions, in DifferentialColumns<T> differentials, int packets, int width, int height, double spacing)
    {
        T turn = T.Of(2 * Math.PI / width * spacing), half = T.Of(Math.PI / height * spacing);
        VectorColumns<T> d = directions;
        for (int packet = 0; packet < packets; packet++)
        {
            T x = d.X[packet], y = d.Y[packet], z = d.Z[packet];
            T sin = T.Sqrt(T.Fma(x, x, z * z));
            T isPole = T.Equal(sin, T.Zero);
            T down = half * y / T.Select(isPole, T.Of(1), sin);
            differentials.DirectionDx.Store(packet, z * turn, T.Zero, -x * turn);
            differentials.DirectionDy.Store(packet, x * down, -sin * half, T.Select(isPole, half * y, z * down));
            differentials.OriginDx.Store(packet, T.Zero, T.Zero, T.Zero);
            differentials.OriginDy.Store(packet, T.Zero, T.Zero, T.Zero);
        }
    }
}
