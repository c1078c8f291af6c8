namespace LabRaytracer;

/// <summary>What a scene file holds.</summary>
public sealed class LoadedScene
{
    internal LoadedScene(Scene scene, RenderOptions renderOptions, SceneOutput output, IReadOnlyDictionary<string, ITexture> textures, SceneSourceMap sourceMap)
    {
        Scene = scene;
        RenderOptions = renderOptions;
        Output = output;
        Textures = textures;
        SourceMap = sourceMap;
    }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>How it is rendered.</summary>
    public RenderOptions RenderOptions { get; }

    /// <summary>How the picture is written.</summary>
    public SceneOutput Output { get; }

    /// <summary>The textures that the file gives names to, by name.</summary>
    public IReadOnlyDictionary<string, ITexture> Textures { get; }

    /// <summary>Where the parts of the scene stand in the file.</summary>
    public SceneSourceMap SourceMap { get; }
}
