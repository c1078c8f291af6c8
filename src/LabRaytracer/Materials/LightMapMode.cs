namespace LabRaytracer;

/// <summary>What a light map stands for.</summary>
public enum LightMapMode
{
    /// <summary>Light besides that of the lamps. The default.</summary>
    Add,

    /// <summary>The light of the lamps: they are not computed for the surface, neither are their shadows on it.</summary>
    Replace,
}
