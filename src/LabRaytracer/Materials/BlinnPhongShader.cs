using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The Blinn-Phong model: k_d (N.L) + k_s (N.H)^n with H halfway between the directions to the lamp and to the viewer (Blinn 1977).</summary>
/// <remarks>
/// Immutable, thread safe. Both cosines are cut off at 0. Its highlight is about as wide as that of <see cref="PhongShader"/> with a quarter of the exponent.
/// A lamp exactly behind the point as the viewer sees it (H = 0) makes no highlight.
/// </remarks>
public sealed class BlinnPhongShader : IWideShader
{
    /// <summary>The shared instance.</summary>
    public static BlinnPhongShader Default { get; } = new();

    /// <inheritdoc/>
    public Intensity Reflect(in SurfaceValues values, Vector3D normal, Vector3D toLight, Vector3D toViewer) =>
        ScalarShader.Reflect(this, values, normal, toLight, toViewer);

    [MethodImpl(MethodImplOptions.NoInlining)]
    void IWideShader.Reflect<F>(in ShaderLanes<F> point, out F red, out F green, out F blue)
    {
        F diffuseCosine = SpecularLobe.DiffuseCosine(point);
        SpecularLobe.Diffuse(point, diffuseCosine, out red, out green, out blue);
        if (SpecularLobe.Exists(point))
        {
            F x = point.LightX + point.ViewX, y = point.LightY + point.ViewY, z = point.LightZ + point.ViewZ;
            F length = F.Sqrt(Lane.Dot(x, y, z, x, y, z));
            F cosine = Lane.Dot(x, y, z, point.NormalX, point.NormalY, point.NormalZ) / F.Select(F.Less(F.Zero, length), length, F.Of(1));
            SpecularLobe.Add(point, diffuseCosine, cosine, ref red, ref green, ref blue);
        }
    }
}
