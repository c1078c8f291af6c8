namespace LabRaytracer;

/// <summary>How a ray changes from one sample of the picture to the next one beside it and below it.</summary>
/// <param name="OriginDx">Change of the origin over one step to the right, world space.</param>
/// <param name="DirectionDx">Change of the unit direction over one step to the right, world space.</param>
/// <param name="OriginDy">Change of the origin over one step down, world space.</param>
/// <param name="DirectionDy">Change of the unit direction over one step down, world space.</param>
/// <remarks>H. Igehy, "Tracing ray differentials", SIGGRAPH 1999. Immutable, thread safe.</remarks>
public readonly record struct RayDifferential(Vector3D OriginDx, Vector3D DirectionDx, Vector3D OriginDy, Vector3D DirectionDy);
