namespace LabRaytracer;

/// <summary>The Phong model: k_d (N.L) + k_s (R.V)^n with R the light's direction mirrored by the normal (Phong 1975).</summary>
/// <remarks>Immutable, thread safe. Both cosines are cut off at 0: nothing shines from below, and an even exponent makes no false highlight.</remarks>
public sealed class PhongShader : IWideShader
{
    /// <summary>The shared instance.</summary>
    public static PhongShader Default { get; } = new();

    /// <inheritdoc/>
    public Intensity Reflect(in SurfaceValues values, Vector3D normal, Vector3D toLight, Vector3D toViewer) =>
        ScalarShader.Reflect(this, values, normal, toLight, toViewer);

    void IWideShader.Reflect<F>(in ShaderLanes<F> point, out F red, out F green, out F blue)
    {
        F cosine = F.Max(Lane.Dot(point.NormalX, point.NormalY, point.NormalZ, point.LightX, point.LightY, point.LightZ), F.Zero);
        red = point.DiffuseR * cosine;
        green = point.DiffuseG * cosine;
        blue = point.DiffuseB * cosine;
    }
}
