namespace LabRaytracer;

/// <summary>How light above display white is brought into [0, 1].</summary>
public enum ToneOperator
{
    /// <summary>Cut at 0 and 1; light in between is left as it is.</summary>
    Clamp,

    /// <summary>x / (1 + x) for each component: never reaches white (Reinhard et al., 2002, equation 3).</summary>
    Reinhard,
}
