namespace LabRaytracer;

/// <summary>Which columns of a surface batch somebody reads: the others are not written.</summary>
[Flags]
internal enum SurfaceNeeds
{
    /// <summary>Point, normals and slack only.</summary>
    None = 0,

    /// <summary>The local point (a mapping or a 3D texture).</summary>
    LocalPoint = 1,

    /// <summary>The local normal (a mapping by faces).</summary>
    LocalNormal = 2,

    /// <summary>The shape's own texture coordinates.</summary>
    SurfaceCoordinates = 4,

    /// <summary>Not a column: t and the point are computed as accurately as the shape can (<see cref="IShapeKernel.Sharpen"/>). Double lanes only.</summary>
    Sharp = 8,

    /// <summary>Not a column: t as accurate as is promised (<see cref="IShapeKernel.Refine"/>). Else it may stay as rough as it was found; surface points do not depend on it.</summary>
    Parameter = 16,
}
