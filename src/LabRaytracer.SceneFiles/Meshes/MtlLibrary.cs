namespace LabRaytracer;

/// <summary>The MTL files that an OBJ file names.</summary>
/// <param name="obj">The OBJ file.</param>
/// <param name="from">Its folder, absolute.</param>
/// <param name="folder">The folder that files must not lie outside of.</param>
internal sealed class MtlLibrary(SceneSource obj, string from, SceneFolder folder)
{
    private readonly Dictionary<string, Material> _materials = new(StringComparer.Ordinal);
    private readonly HashSet<string> _loaded = new(StringComparer.Ordinal);
    private readonly HashSet<string> _unknown = new(StringComparer.Ordinal);
    private readonly List<SceneFileError> _mistakes = [];

    /// <summary>The materials by name.</summary>
    public IReadOnlyDictionary<string, Material> Materials => _materials;

    /// <summary>Where materials and textures stand.</summary>
    public SceneSourceMap SourceMap { get; } = new(obj.File);

    /// <summary>Reads the files of a line mtllib: one whose name may have spaces, or several without.</summary>
    /// <param name="names">What stands after the word mtllib.</param>
    /// <param name="offset">Where the line is.</param>
    public void Load(string names, int offset)
    {
        string[] all = folder.Find(Portable(names), from, out _, isPicture: false) is null ? [names] : names.Split([' ', '\t'], StringSplitOptions.RemoveEmptyEntries);
        if (all.Length == 0)
        {
            Mistake(offset, "the line names no file", "mtllib with the names of MTL files");
        }

        foreach (string name in all)
        {
            if (folder.Find(Portable(name), from, out string path, isPicture: false) is { } why)
            {
                Mistake(offset, why, "MTL files in the folder of the OBJ file");
            }
            else if (_loaded.Add(path))
            {
                Read(Path.Combine(Path.GetDirectoryName(obj.File) ?? "", Portable(name)), path);
            }
        }
    }

    /// <summary>Notes a mistake if files were read and none has a material of this name.</summary>
    public void CheckName(string name, int offset)
    {
        if (_loaded.Count > 0 && !_materials.ContainsKey(name) && _unknown.Add(name))
        {
            string allowed = _materials.Count == 0 ? "none, the MTL files have no materials" : Wording.List(_materials.Keys);
            Mistake(offset, $"there is no material {Wording.Quote(name)}{Wording.Suggestion(name, _materials.Keys)}", allowed);
        }
    }

    /// <summary>Throws if there was any mistake.</summary>
    /// <exception cref="SceneFileException">There was.</exception>
    public void ThrowIfMistaken()
    {
        if (_mistakes.Count > 0)
        {
            throw new SceneFileException(_mistakes);
        }
    }

    /// <summary>A name as other systems write it, with slashes between folders.</summary>
    public static string Portable(string name) => name.Replace('\\', '/');

    private void Read(string shownPath, string path)
    {
        try
        {
            SceneSource source = new(shownPath, TextFiles.Read(path, folder.Options.MaxMeshBytes, "material"));
            MtlReader reader = new(source, Path.GetDirectoryName(path) ?? "", folder, SourceMap);
            foreach (Material material in reader.Read())
            {
                _materials.TryAdd(material.Name, material);
            }

            _mistakes.AddRange(reader.Mistakes);
        }
        catch (SceneFileException failure)
        {
            _mistakes.AddRange(failure.Errors);
        }
    }

    private void Mistake(int offset, string what, string allowed) => _mistakes.Add(new SceneFileError(obj.Locate(offset), what, allowed));
}
