namespace LabRaytracer;

/// <summary>What is known and noted while one scene file is read.</summary>
internal sealed class SceneReading(SceneTree tree, string folder, SceneLoadOptions options)
{
    private const int MostMistakes = 1000;
    private readonly List<SceneFileError> _mistakes = [.. tree.Mistakes];
    private int _unlisted;

    /// <summary>The scene's folder, absolute.</summary>
    public string Folder => folder;

    public SceneLoadOptions Options => options;

    /// <summary>Where the parts of the scene stand in the file.</summary>
    public SceneSourceMap SourceMap { get; } = new(tree.Source);

    /// <summary>Name of the texture or material that is being read; empty for one without.</summary>
    public string NameBeingRead { get; set; } = "";

    /// <summary>Textures by name; null for one with a mistake in it.</summary>
    public Dictionary<string, ITexture?> Textures { get; } = new(StringComparer.Ordinal);

    /// <summary>Materials by name; null for one with a mistake in it.</summary>
    public Dictionary<string, Material?> Materials { get; } = new(StringComparer.Ordinal);

    /// <summary>Picture files that are open, by full path.</summary>
    public Dictionary<string, Texture> Pictures { get; } = new(StringComparer.Ordinal);

    /// <summary>Notes a mistake; the result is false, for <c>return</c>.</summary>
    public bool Mistake(SceneNode node, string what, string? allowed)
    {
        if (_mistakes.Count >= MostMistakes)
        {
            _unlisted++;
            return false;
        }

        string path = node.Path();
        _mistakes.Add(new SceneFileError(node.Location(), path.Length == 0 ? what : $"{path}: {what}", allowed));
        return false;
    }

    /// <summary>Notes that a value is not what is allowed; the result is false, for <c>return</c>.</summary>
    public bool WrongValue(SceneNode node, string allowed) => Mistake(node, $"{Describe(node)} does not fit", allowed);

    /// <summary>Throws if there was any mistake.</summary>
    /// <exception cref="SceneFileException">There was.</exception>
    public void ThrowIfMistaken()
    {
        if (_mistakes.Count == 0)
        {
            return;
        }

        List<SceneFileError> sorted = [.. _mistakes.OrderBy(mistake => mistake.Line).ThenBy(mistake => mistake.Column)];
        if (_unlisted > 0)
        {
            sorted.Add(sorted[^1] with { Message = $"and {_unlisted} more mistakes", Allowed = null });
        }

        throw new SceneFileException(sorted);
    }

    private static string Describe(SceneNode node) => node.Kind switch
    {
        NodeKind.Object => "an object { ... }",
        NodeKind.Array => node.Count == 1 ? "a list of 1 value" : $"a list of {node.Count} values",
        NodeKind.Text => $"the text {Wording.Quote(node.Text())}",
        NodeKind.Number => $"the number {Wording.Name(node.NumberText())}",
        NodeKind.True => "true",
        NodeKind.False => "false",
        _ => "null",
    };
}
