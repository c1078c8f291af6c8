namespace LabRaytracer;

/// <summary>The axes that complete a normal to a frame.</summary>
internal static class PlaneAxes
{
    /// <summary>The axes x and z of a right-handed frame whose y axis is the unit normal; exactly +X and +Z for +Y.</summary>
    public static (Vector3D X, Vector3D Z) Of(Vector3D normal)
    {
        if (normal == Vector3D.UnitY)
        {
            return (Vector3D.UnitX, Vector3D.UnitZ);
        }

        Vector3D aside = Math.Abs(normal.Z) < 0.9 ? Vector3D.UnitZ : Vector3D.UnitX;
        Vector3D x = Vector3D.Cross(normal, aside).Normalized();
        return (x, Vector3D.Cross(x, normal).Normalized());
    }
}
