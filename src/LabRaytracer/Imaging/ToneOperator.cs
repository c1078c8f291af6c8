namespace LabRaytracer;

/// <summary>How light above display white is brought into [0, 1].</summary>
public enum ToneOperator
{
    /// <summary>Cut at 0 and 1; light in between is left as it is.</summary>
    Clamp,

    /// <summary>x / (1 + x) for each component: never reaches white (Reinhard et al., 2002, equation 3).</summary>
    Reinhard,

    /// <summary>
    /// A filmic curve: (2.51 x^2 + 0.03 x) / (2.43 x^2 + 0.59 x + 0.14) for each component, cut at 1: Narkowicz's fit of the ACES curve (2016). Dark tones lose
    /// contrast towards black, bright ones roll off; white is reached at about x = 7.2.
    /// </summary>
    Aces,
}
