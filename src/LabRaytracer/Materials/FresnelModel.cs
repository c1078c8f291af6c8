namespace LabRaytracer;

/// <summary>How a transparent material shares light between reflection and refraction.</summary>
public enum FresnelModel
{
    /// <summary>Fixed: the transparency is refracted whatever the angle (Whitted 1980). The default.</summary>
    None,

    /// <summary>By the angle, exact Fresnel equations for unpolarised light between two dielectrics.</summary>
    Dielectric,

    /// <summary>By the angle, Schlick's approximation R0 + (1 - R0)(1 - cos)^5 (Schlick 1994).</summary>
    Schlick,
}
