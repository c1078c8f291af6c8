namespace LabRaytracer;

/// <summary>The folder of a scene: what its files may name, and the pictures that are open.</summary>
/// <param name="root">The folder, absolute.</param>
/// <param name="options">Whether files outside it may be named.</param>
internal sealed class SceneFolder(string root, SceneLoadOptions options)
{
    private static readonly string[] s_devices = ["con", "prn", "aux", "nul", "conin$", "conout$", "clock$"];
    private readonly Dictionary<string, Texture> _pictures = new(StringComparer.Ordinal);

    /// <summary>The folder, absolute.</summary>
    public string Root => root;

    public SceneLoadOptions Options => options;

    /// <summary>OBJ files that were read, by full path and by whether MTL files were; null for one with mistakes.</summary>
    public Dictionary<(string Path, bool Materials), ObjScene?> Loaded { get; } = [];

    /// <summary>Finds a file.</summary>
    /// <param name="name">Its name in a file.</param>
    /// <param name="from">Folder of that file, absolute.</param>
    /// <param name="path">Its absolute path.</param>
    /// <param name="isPicture">Whether it is a picture, which a checker may stand in for.</param>
    /// <returns>Why it cannot be used; null if it can. The same on every system, so that a scene that loads here loads everywhere.</returns>
    public string? Find(string name, string from, out string path, bool isPicture)
    {
        path = "";
        if (Refusal(name, options.AllowOutsidePaths) is { } refusal)
        {
            return $"the file {Wording.Quote(name)} {refusal}";
        }

        path = Path.GetFullPath(Path.Combine(from, name));
        if (!options.AllowOutsidePaths && !path.StartsWith(root.TrimEnd('/', '\\') + Path.DirectorySeparatorChar, StringComparison.Ordinal))
        {
            return $"the file {Wording.Quote(name)} lies outside the scene's folder";
        }

        options.FileNamed?.Invoke(path);
        return File.Exists(path) ? null
            : Directory.Exists(path) ? $"{Wording.Quote(name)} is a folder"
            : isPicture && options.MissingPictures == MissingPictures.Checker ? null
            : $"the file {Wording.Quote(name)} does not exist{Wording.Suggestion(Path.GetFileName(name), Neighbours(path))}";
    }

    /// <summary>A picture file; it is opened and decoded once, however many textures look it up in their own ways.</summary>
    /// <param name="path">Its absolute path.</param>
    /// <param name="place">Where it is named.</param>
    public Texture Open(string path, Func<SceneLocation> place)
    {
        if (!_pictures.TryGetValue(path, out Texture? picture))
        {
            picture = options.MissingPictures == MissingPictures.Checker ? OpenOrStandIn(path, place) : Texture.Load(path);
            _pictures.Add(path, picture);
        }

        return picture;
    }

    private Texture OpenOrStandIn(string path, Func<SceneLocation> place)
    {
        void Warn(string what) => options.Warned?.Invoke(new SceneFileError(place(), $"{what}; a checker stands in"));
        if (!File.Exists(path))
        {
            Warn($"the file {Wording.Quote(Path.GetFileName(path))} does not exist");
            return Texture.LoadOrStandIn(path, _ => { });
        }

        return Texture.LoadOrStandIn(path, failure => Warn(Wording.Reason(failure)));
    }

    /// <summary>Why a name is refused whatever lies there; null if it is not.</summary>
    public static string? Refusal(string name, bool allowOutside)
    {
        if (name.Length == 0)
        {
            return "has no name";
        }

        if (name.Any(char.IsControl))
        {
            return "has a control character in its name";
        }

        if (name.Contains("://", StringComparison.Ordinal))
        {
            return "is an address of the network";
        }

        if (name.Split('/', '\\').Any(IsDevice))
        {
            return "is a device";
        }

        if (allowOutside)
        {
            return null;
        }

        return Path.IsPathRooted(name) || name[0] is '/' or '\\' or '~' || name.Contains(':') ? "has an absolute path"
            : name.Contains('\\') ? "has a backslash in its name"
            : null;
    }

    // Windows takes these for devices in any folder and with any extension.
    private static bool IsDevice(string step)
    {
        string stem = step.Split('.', ':')[0].TrimEnd(' ').ToLowerInvariant();
        return s_devices.Contains(stem) || (stem.Length == 4 && stem[..3] is "com" or "lpt" && char.IsDigit(stem[3]));
    }

    private static IEnumerable<string> Neighbours(string path)
    {
        string? folder = Path.GetDirectoryName(path);
        try
        {
            return Directory.Exists(folder) ? [.. Directory.EnumerateFiles(folder).Take(1000).Select(file => Path.GetFileName(file))] : [];
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            return [];
        }
    }
}
