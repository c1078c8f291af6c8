namespace LabRaytracer;

/// <summary>Light from all around made ready: its radiance as a material that shines, and the table that samples are drawn from.</summary>
/// <param name="Light">The light.</param>
/// <param name="Sky">A material with emission only, mapped by direction.</param>
internal sealed record CompiledEnvironment(EnvironmentLight Light, CompiledMaterial Sky)
{
    /// <summary>The table; made when textures are ready.</summary>
    public EnvironmentTable? Table { get; set; }

    /// <summary>Tells whether the radiance is the same in all directions.</summary>
    public bool IsConstant => Sky.Emission.Lookup < 0;
}
