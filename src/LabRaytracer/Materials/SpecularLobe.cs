using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>What the models with a highlight share: k_d (N.L) + k_s cosine^n.</summary>
internal static class SpecularLobe
{
    /// <summary>Tells whether any lane has a highlight at all.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Exists<F>(in ShaderLanes<F> point)
        where F : unmanaged, IReal<F> =>
        F.Any(~(F.Equal(point.SpecularR, F.Zero) & F.Equal(point.SpecularG, F.Zero) & F.Equal(point.SpecularB, F.Zero)));

    /// <summary>N.L, cut off at 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F DiffuseCosine<F>(in ShaderLanes<F> point)
        where F : unmanaged, IReal<F> =>
        F.Max(Lane.Dot(point.NormalX, point.NormalY, point.NormalZ, point.LightX, point.LightY, point.LightZ), F.Zero);

    /// <summary>Diffuse part alone.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Diffuse<F>(in ShaderLanes<F> point, F diffuseCosine, out F red, out F green, out F blue)
        where F : unmanaged, IReal<F>
    {
        red = point.DiffuseR * diffuseCosine;
        green = point.DiffuseG * diffuseCosine;
        blue = point.DiffuseB * diffuseCosine;
    }

    /// <summary>Adds k_s cosine^n; nothing where the cosine is not above 0 or the lamp is not above the surface.</summary>
    /// <remarks>Where k_s is 0 this adds exactly 0, so that skipping it for a whole packet changes no bits.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Add<F>(in ShaderLanes<F> point, F diffuseCosine, F cosine, ref F red, ref F green, ref F blue)
        where F : unmanaged, IReal<F>
    {
        // Rounding may leave a cosine a hair above 1; a large exponent would make that visible.
        F lit = F.Less(F.Zero, diffuseCosine) & F.Less(F.Zero, cosine);
        F lobe = lit & Elementary.Pow(F.Min(F.Select(lit, cosine, F.Of(1)), F.Of(1)), point.Shininess);
        red = F.Fma(point.SpecularR, lobe, red);
        green = F.Fma(point.SpecularG, lobe, green);
        blue = F.Fma(point.SpecularB, lobe, blue);
    }
}
