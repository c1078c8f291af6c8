using LabRaytracer;

namespace RenderScene;

/// <summary>Scene files on their way to a picture, with failures that name the place in the file.</summary>
internal static class SceneInput
{
    /// <summary>Reads a scene file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="options">What it may name; null for the defaults.</param>
    /// <exception cref="InputException">It needs generated files that are not there yet.</exception>
    /// <exception cref="SceneFileException">It cannot be read.</exception>
    public static LoadedScene Load(string path, SceneLoadOptions? options = null)
    {
        BenchData.ThrowIfMissing(path);
        return SceneFile.Load(path, options);
    }

    /// <summary>Renders a scene and shows the progress.</summary>
    /// <exception cref="SceneFileException">A picture of the scene cannot be decoded.</exception>
    public static RenderResult Render(LoadedScene scene, string title, RenderOptions options, AppConsole console, CancellationToken stop)
    {
        try
        {
            return ProgressDisplay.Run(console, title, progress => Renderer.Render(scene.Scene, options, progress, stop));
        }
        catch (Exception failure) when (Cause(failure) is { } cause && FindTexture(scene.Scene, cause) is { } texture)
        {
            throw scene.SourceMap.Explain(texture, cause);
        }
    }

    /// <summary>The failure of a picture file among those that made the render fail, or null.</summary>
    private static Exception? Cause(Exception? failure) => failure switch
    {
        null => null,
        PictureFormatException or FileNotFoundException => failure,
        AggregateException several => several.InnerExceptions.Select(Cause).FirstOrDefault(cause => cause is not null),
        _ => Cause(failure.InnerException),
    };

    private static Texture? FindTexture(Scene scene, Exception cause)
    {
        string? path = cause is PictureFormatException format ? format.Path : ((FileNotFoundException)cause).FileName;
        return scene.Objects.Select(item => item.Material).Distinct().SelectMany(Textures).Append(scene.Background.Texture)
            .OfType<Texture>().FirstOrDefault(texture => texture.Path == path);
    }

    private static IEnumerable<ITexture?> Textures(Material material) =>
    [
        material.Ambient?.Texture, material.Diffuse.Texture, material.Specular.Texture, material.Shininess.Texture, material.Reflection.Texture,
        material.Transparency.Texture, material.IndexOfRefraction.Texture, material.Emission.Texture,
    ];
}
