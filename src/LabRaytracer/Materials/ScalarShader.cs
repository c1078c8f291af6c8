namespace LabRaytracer;

/// <summary>The call for one point of a wide lighting model: the same formulas with one float lane.</summary>
internal static class ScalarShader
{
    /// <summary><see cref="IShader.Reflect"/> by the wide path.</summary>
    public static Intensity Reflect(IWideShader shader, in SurfaceValues values, Vector3D normal, Vector3D toLight, Vector3D toViewer)
    {
        ShaderLanes<Float1> point = new()
        {
            DiffuseR = new(values.Diffuse.R), DiffuseG = new(values.Diffuse.G), DiffuseB = new(values.Diffuse.B),
            SpecularR = new(values.Specular.R), SpecularG = new(values.Specular.G), SpecularB = new(values.Specular.B),
            Shininess = new(values.Shininess),
            NormalX = new((float)normal.X), NormalY = new((float)normal.Y), NormalZ = new((float)normal.Z),
            LightX = new((float)toLight.X), LightY = new((float)toLight.Y), LightZ = new((float)toLight.Z),
            ViewX = new((float)toViewer.X), ViewY = new((float)toViewer.Y), ViewZ = new((float)toViewer.Z),
        };
        shader.Reflect(point, out Float1 red, out Float1 green, out Float1 blue);
        return new Intensity(red.Value, green.Value, blue.Value);
    }
}
