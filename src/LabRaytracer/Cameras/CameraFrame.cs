namespace LabRaytracer;

/// <summary>Position and axes of a camera, world space; the axes have length 1 and are perpendicular.</summary>
internal readonly record struct CameraFrame(Point3D Eye, Vector3D Right, Vector3D Up, Vector3D Forward)
{
    /// <summary>The frame of a camera that looks at a point.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A point is not finite, both are the same, or up lies along the line of sight.</exception>
    public static CameraFrame LookAt(Point3D eye, Point3D target, Vector3D up)
    {
        if (!eye.IsFinite || !target.IsFinite || eye == target || !(target - eye).IsFinite)
        {
            throw new ArgumentOutOfRangeException(nameof(target), target, $"A camera at {eye} needs a finite target other than its own position.");
        }

        Vector3D forward = (target - eye).Normalized();
        Vector3D right = up.IsFinite ? Vector3D.Cross(forward, up) : Vector3D.Zero;
        if (!(right.Length > 1e-12 * up.Length))
        {
            throw new ArgumentOutOfRangeException(nameof(up), up, "The up direction of a camera needs a finite length above 0 and must not lie along the line of sight.");
        }

        right = right.Normalized();
        return new CameraFrame(eye, right, Vector3D.Cross(right, forward).Normalized(), forward);
    }
}
