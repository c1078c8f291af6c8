namespace LabRaytracer;

/// <summary>How much light a smooth boundary between two dielectrics reflects.</summary>
internal static class Fresnel
{
    /// <summary>Share of unpolarised light that is reflected, [0, 1] (Fresnel equations).</summary>
    /// <param name="ratio">Index of refraction on the near side over the far side, above 0.</param>
    /// <param name="cosNear">Cosine between ray and normal on the near side, [0, 1].</param>
    /// <param name="cosFar">Cosine between ray and normal on the far side, [0, 1].</param>
    public static double Dielectric(double ratio, double cosNear, double cosFar)
    {
        double parallel = (cosNear - (ratio * cosFar)) / (cosNear + (ratio * cosFar));
        double perpendicular = ((ratio * cosNear) - cosFar) / ((ratio * cosNear) + cosFar);
        return ((parallel * parallel) + (perpendicular * perpendicular)) / 2;
    }

    /// <summary>Schlick's approximation R0 + (1 - R0)(1 - cos)^5, cosine on the optically thinner side, [0, 1].</summary>
    /// <param name="ratio">Index of refraction on the near side over the far side, above 0.</param>
    /// <param name="cosNear">Cosine on the near side, [0, 1].</param>
    /// <param name="cosFar">Cosine on the far side, [0, 1].</param>
    public static double Schlick(double ratio, double cosNear, double cosFar)
    {
        double r0 = (1 - ratio) / (1 + ratio);
        r0 *= r0;
        double rest = 1 - (ratio > 1 ? cosFar : cosNear);
        double square = rest * rest;
        return r0 + ((1 - r0) * square * square * rest);
    }
}
