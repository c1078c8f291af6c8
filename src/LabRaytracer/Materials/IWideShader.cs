namespace LabRaytracer;

/// <summary>A lighting model that shades many points at a time, with the same bits as one at a time in float lanes.</summary>
internal interface IWideShader : IShader
{
    /// <summary>Factors for one lamp's intensity.</summary>
    /// <param name="point">Coefficients and directions.</param>
    /// <param name="red">Red factors.</param>
    /// <param name="green">Green factors.</param>
    /// <param name="blue">Blue factors.</param>
    void Reflect<F>(in ShaderLanes<F> point, out F red, out F green, out F blue)
        where F : unmanaged, IReal<F>;
}
