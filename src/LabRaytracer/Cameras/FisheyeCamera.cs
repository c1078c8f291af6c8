namespace LabRaytracer;

/// <summary>A fisheye camera (Polish: rybie oko): the distance from the middle of the picture is in proportion to the angle from the line of sight.</summary>
/// <remarks>
/// Immutable, thread safe. With f, r, u as of a <see cref="PerspectiveCamera"/>, a = (2 x - width) / height, b = 1 - 2 y / height and rho = sqrt(a^2 + b^2), the ray has the angle
/// t = rho fov / 2 to f and the direction f cos t + (r a + u b) / rho sin t (equidistant projection). The circle of the stated angle of view touches the top and bottom of the picture;
/// outside of it the angle goes on, up to half a turn, where the ray goes straight back.
/// </remarks>
public sealed class FisheyeCamera : Camera
{
    private readonly CameraFrame _frame;

    /// <summary>Creates a fisheye camera.</summary>
    /// <param name="eye">Where the camera stands, world space; finite.</param>
    /// <param name="target">Where it looks, world space; finite, not the eye.</param>
    /// <param name="fieldOfViewDegrees">Vertical angle of view, degrees, (0, 360].</param>
    /// <param name="up">What is up on the picture, world space; null for +Y. Not along the line of sight.</param>
    /// <exception cref="ArgumentOutOfRangeException">An argument is outside its range.</exception>
    public FisheyeCamera(Point3D eye, Point3D target, double fieldOfViewDegrees, Vector3D? up = null)
    {
        if (!(fieldOfViewDegrees is > 0 and <= 360))
        {
            throw new ArgumentOutOfRangeException(nameof(fieldOfViewDegrees), fieldOfViewDegrees, "The field of view of a fisheye must be in (0, 360] degrees.");
        }

        _frame = CameraFrame.LookAt(eye, target, up ?? Vector3D.UnitY);
        FieldOfViewDegrees = fieldOfViewDegrees;
        Target = target;
    }

    /// <summary>Where the camera stands, world space.</summary>
    public Point3D Eye => _frame.Eye;

    /// <summary>Where it looks, world space.</summary>
    public Point3D Target { get; }

    /// <summary>Vertical angle of view, degrees, (0, 360].</summary>
    public double FieldOfViewDegrees { get; }

    /// <inheritdoc/>
    public override Ray RayAt(double x, double y, int width, int height)
    {
        double a = ((2 * x) - width) / height, b = (height - (2 * y)) / height;
        double rho = Math.Sqrt((a * a) + (b * b));
        double turns = Math.Min(rho * (FieldOfViewDegrees / 720), 0.5);
        (Double1 sin, Double1 cos) = Elementary.SinCosTurns(new Double1(turns));
        double aside = rho > 0 ? sin.Value / rho : 0;
        Vector3D direction = (_frame.Forward * cos.Value) + (_frame.Right * (a * aside)) + (_frame.Up * (b * aside));
        return new Ray(Eye, direction.Normalized());
    }
}
