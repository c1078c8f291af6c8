using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>How much light a smooth boundary between two dielectrics reflects.</summary>
internal static class Fresnel
{
    /// <summary>Share of unpolarised light that is reflected, [0, 1] (Fresnel equations).</summary>
    /// <param name="ratio">Index of refraction on the near side over the far side, above 0.</param>
    /// <param name="cosNear">Cosine between ray and normal on the near side, [0, 1].</param>
    /// <param name="cosFar">Cosine between ray and normal on the far side, [0, 1].</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T Dielectric<T>(T ratio, T cosNear, T cosFar)
        where T : unmanaged, IReal<T>
    {
        T parallel = (cosNear - (ratio * cosFar)) / (cosNear + (ratio * cosFar));
        T perpendicular = ((ratio * cosNear) - cosFar) / ((ratio * cosNear) + cosFar);
        return ((parallel * parallel) + (perpendicular * perpendicular)) * T.Of(0.5);
    }

    /// <summary>Schlick's approximation R0 + (1 - R0)(1 - cos)^5, cosine on the optically thinner side, [0, 1].</summary>
    /// <param name="ratio">Index of refraction on the near side over the far side, above 0.</param>
    /// <param name="cosNear">Cosine on the near side, [0, 1].</param>
    /// <param name="cosFar">Cosine on the far side, [0, 1].</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static T Schlick<T>(T ratio, T cosNear, T cosFar)
        where T : unmanaged, IReal<T>
    {
        T one = T.Of(1);
        T r0 = (one - ratio) / (one + ratio);
        r0 *= r0;
        T rest = one - T.Select(T.Less(one, ratio), cosFar, cosNear);
        T square = rest * rest;
        return r0 + ((one - r0) * square * square * rest);
    }
}
