namespace LabRaytracer;

/// <summary>Normals of the unit form, of any length, and their changes over a step.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal struct NormalLanes<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Normal.</summary>
    public R X, Y, Z;

    /// <summary>Its change over the step.</summary>
    public R StepX, StepY, StepZ;
}
