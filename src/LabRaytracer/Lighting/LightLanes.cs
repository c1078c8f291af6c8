namespace LabRaytracer;

/// <summary>Samples of one lamp, as many as a lane type is wide: <see cref="LightSample"/> without the colour.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal struct LightLanes<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Towards the lamp, world space, length 1.</summary>
    public R DirectionX, DirectionY, DirectionZ;

    /// <summary>Distance of the lamp; infinite for directional light.</summary>
    public R Distance;

    /// <summary>Share of the lamp's intensity that arrives; 0 where no light does.</summary>
    public R Share;
}
