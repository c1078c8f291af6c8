namespace LabRaytracer;

/// <summary>What a lighting model reads, in float lanes.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
internal struct ShaderLanes<F>
    where F : unmanaged, IReal<F>
{
    /// <summary>k_d.</summary>
    public F DiffuseR, DiffuseG, DiffuseB;

    /// <summary>k_s.</summary>
    public F SpecularR, SpecularG, SpecularB;

    /// <summary>Specular exponent.</summary>
    public F Shininess;

    /// <summary>Shading normal on the viewer's side, length 1.</summary>
    public F NormalX, NormalY, NormalZ;

    /// <summary>Towards the lamp, length 1.</summary>
    public F LightX, LightY, LightZ;

    /// <summary>Towards the viewer, length 1.</summary>
    public F ViewX, ViewY, ViewZ;
}
