namespace LabRaytracer;

/// <summary>The frame of a flat shape: its points are Center + x AxisX + z AxisZ, with (x, z) inside the outline.</summary>
/// <param name="Center">Origin of the local frame, object space.</param>
/// <param name="Normal">Unit normal, in the direction of AxisZ x AxisX.</param>
/// <param name="AxisX">Object-space vector of one unit of local x.</param>
/// <param name="AxisZ">Object-space vector of one unit of local z.</param>
internal sealed record FlatFrame(Point3D Center, Vector3D Normal, Vector3D AxisX, Vector3D AxisZ)
{
    /// <summary>Scalar product with this vector gives local x of a point of the plane.</summary>
    public Vector3D DualX { get; } = Dual(Vector3D.Cross(Normal, AxisZ), AxisX);

    /// <summary>Scalar product with this vector gives local z of a point of the plane.</summary>
    public Vector3D DualZ { get; } = Dual(Vector3D.Cross(AxisX, Normal), AxisZ);

    private static Vector3D Dual(Vector3D direction, Vector3D axis) => direction / Vector3D.Dot(direction, axis);
}
