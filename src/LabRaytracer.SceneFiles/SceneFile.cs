namespace LabRaytracer;

/// <summary>Reads scenes from JSON files; comments and trailing commas are allowed.</summary>
/// <remarks>Thread safe.</remarks>
public static class SceneFile
{
    /// <summary>Reads a scene. Picture files are looked for now, but decoded when a renderer needs them.</summary>
    /// <param name="path">Path of the file; the files that it names are relative to its folder.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <exception cref="SceneFileException">The file cannot be read, or has mistakes: all of them are listed.</exception>
    public static LoadedScene Load(string path, SceneLoadOptions? options = null)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        options ??= SceneLoadOptions.Default;
        byte[] bytes = TextFiles.Read(path, options.MaxBytes, "scene");
        return Read(new SceneSource(path, bytes), Path.GetDirectoryName(Path.GetFullPath(path)) ?? "", options);
    }

    /// <summary>Reads a scene that is in memory.</summary>
    /// <param name="source">Name for messages, and the bytes.</param>
    /// <param name="folder">The folder that files are relative to, absolute.</param>
    /// <param name="options">How.</param>
    /// <exception cref="SceneFileException">There are mistakes.</exception>
    internal static LoadedScene Read(SceneSource source, string folder, SceneLoadOptions options)
    {
        SceneTree tree = SceneTreeReader.Read(source);
        SceneReading reading = new(tree, new SceneFolder(folder, options));
        RootFormat.Scene.TryRead(tree.Root, reading, out LoadedScene? scene);
        reading.ThrowIfMistaken();
        return scene!;
    }
}
