namespace LabRaytracer;

/// <summary>What somebody reads of <see cref="SurfaceSteps{F}"/>.</summary>
[Flags]
internal enum StepNeeds
{
    /// <summary>Nothing.</summary>
    None = 0,

    /// <summary>Steps in the shape's unit form.</summary>
    Local = 1,

    /// <summary>Changes of the shading normal.</summary>
    Normal = 2,

    /// <summary>Gradient of the shape's own coordinates.</summary>
    SurfaceGradient = 4,
}
