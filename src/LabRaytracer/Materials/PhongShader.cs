using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The Phong model: k_d (N.L) + k_s (R.V)^n with R = 2 (N.L) N - L, the light's direction mirrored by the normal (Phong 1975).</summary>
/// <remarks>
/// Immutable, thread safe. Both cosines are cut off at 0: nothing shines from below, and an even exponent makes no false highlight.
/// n = 0 gives the full k_s wherever R.V &gt; 0.
/// </remarks>
public sealed class PhongShader : IWideShader
{
    /// <summary>The shared instance.</summary>
    public static PhongShader Default { get; } = new();

    /// <inheritdoc/>
    public Intensity Reflect(in SurfaceValues values, Vector3D normal, Vector3D toLight, Vector3D toViewer) =>
        ScalarShader.Reflect(this, values, normal, toLight, toViewer);

    void IWideShader.Reflect<F>(in ShaderLanes<F> point, out F red, out F green, out F blue) => Formula(point, out red, out green, out blue);

    /// <summary>The same, not virtual: ahead-of-time compilers do not see through virtual generic methods.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    internal static void Formula<F>(in ShaderLanes<F> point, out F red, out F green, out F blue)
        where F : unmanaged, IReal<F>
    {
        F diffuseCosine = SpecularLobe.DiffuseCosine(point);
        SpecularLobe.Diffuse(point, diffuseCosine, out red, out green, out blue);
        if (SpecularLobe.Exists(point))
        {
            F twice = diffuseCosine + diffuseCosine;
            F mirroredX = F.Fma(twice, point.NormalX, -point.LightX);
            F mirroredY = F.Fma(twice, point.NormalY, -point.LightY);
            F mirroredZ = F.Fma(twice, point.NormalZ, -point.LightZ);
            F cosine = Lane.Dot(mirroredX, mirroredY, mirroredZ, point.ViewX, point.ViewY, point.ViewZ);
            SpecularLobe.Add(point, diffuseCosine, cosine, ref red, ref green, ref blue);
        }
    }
}
