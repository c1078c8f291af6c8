namespace LabRaytracer;

/// <summary>The matte model: k_d (N.L), no highlight (Lambert 1760).</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class LambertShader : IWideShader
{
    /// <summary>The shared instance.</summary>
    public static LambertShader Default { get; } = new();

    /// <summary>The model has no highlight.</summary>
    public bool UsesSpecular => false;

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
