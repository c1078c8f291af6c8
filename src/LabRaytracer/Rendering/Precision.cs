namespace LabRaytracer;

/// <summary>Precision of geometry and mapping. Colours are float in both.</summary>
public enum Precision
{
    /// <summary>53-bit significands: the default.</summary>
    Double,

    /// <summary>24-bit significands throughout: for previews, and to see what precision is worth.</summary>
    Single,

    /// <summary>
    /// As <see cref="Double"/>, and every visible hit of a sphere, an upright cylinder or a plane is computed once more with twice the digits, or with as many as it
    /// takes: its ray parameter is the double nearest to the exact one (of the ray in object space, where the object has a transform).
    /// </summary>
    Exact,
}
