namespace LabRaytracer;

/// <summary>How a texture changes a material's coefficient k: the result for amount 1.</summary>
public enum BlendMode
{
    /// <summary>k T: the sheet's "modulation". The default.</summary>
    Multiply,

    /// <summary>T.</summary>
    Replace,

    /// <summary>k + T.</summary>
    Add,

    /// <summary>The mean of k and T.</summary>
    Mix,
}
