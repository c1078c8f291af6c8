namespace LabRaytracer;

/// <summary>Lamps that rays see.</summary>
internal static class VisibleLamps
{
    /// <summary>An object for each visible lamp of a scene: a surface that shines and casts no shadow.</summary>
    public static IEnumerable<SceneObject> Of(Scene scene) =>
        scene.Lights.OfType<QuadLight>().Where(light => light.IsVisible).Select(light => new SceneObject(light.Quad, Surface(light)) { Name = "lamp", CastsShadows = false });

    private static Material Surface(QuadLight light) => new()
    {
        Diffuse = Intensity.Black, Emission = light.Radiance, Shader = LambertShader.Default, EmitsFromFrontOnly = light.Sides == LightSides.Front,
    };
}
