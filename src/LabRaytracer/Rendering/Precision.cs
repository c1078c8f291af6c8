namespace LabRaytracer;

/// <summary>Precision of geometry and mapping. Colours are float in both.</summary>
public enum Precision
{
    /// <summary>53-bit significands: the default.</summary>
    Double,

    /// <summary>24-bit significands throughout: for previews, and to see what precision is worth.</summary>
    Single,
}
