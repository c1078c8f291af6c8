namespace LabRaytracer;

/// <summary>What a gradient runs along.</summary>
public enum GradientKind
{
    /// <summary>Along u: from left to right over the picture.</summary>
    U,

    /// <summary>Along v: from the bottom to the top of the picture.</summary>
    V,

    /// <summary>Along an axis of the object: t = axis . p.</summary>
    Axis,

    /// <summary>Away from a point of the object: t = |p - center|.</summary>
    Radial,
}
