namespace LabRaytracer;

/// <summary>What is known and noted while one scene file is read.</summary>
internal sealed class SceneReading(SceneTree tree, SceneFolder folder)
{
    private const int MostMistakes = 1000;
    private readonly List<SceneFileError> _mistakes = [.. tree.Mistakes];
    private readonly List<SceneFileError> _others = [];
    private int _unlisted;

    /// <summary>The scene's folder and what is open of it.</summary>
    public SceneFolder Folder => folder;

    /// <summary>Where the parts of the scene stand in the file.</summary>
    public SceneSourceMap SourceMap { get; } = new(tree.Source.File);

    /// <summary>Notes where a part of the scene stands.</summary>
    public void Note(object part, SceneNode node) => SourceMap.Note(part, tree.Source, node.Offset);

    /// <summary>Name of the texture or material that is being read; empty for one without.</summary>
    public string NameBeingRead { get; set; } = "";

    /// <summary>Textures by name.</summary>
    public NamedThings<ITexture> Textures { get; } = new();

    /// <summary>Materials by name.</summary>
    public NamedThings<Material> Materials { get; } = new();

    /// <summary>The background, once it is read.</summary>
    public TextureSlot Background { get; set; } = Intensity.Black;

    /// <summary>How the background is turned, once it is read.</summary>
    public Transform BackgroundRotation { get; set; } = Transform.Identity;

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

    /// <summary>Takes over the mistakes of a file that the scene names; the result is false, for <c>return</c>.</summary>
    public bool Mistakes(IEnumerable<SceneFileError> mistakes)
    {
        _others.AddRange(mistakes);
        return false;
    }

    /// <summary>Notes that a value is not what is allowed; the result is false, for <c>return</c>.</summary>
    public bool WrongValue(SceneNode node, string allowed) => Mistake(node, $"{Describe(node)} does not fit", allowed);

    /// <summary>Throws if there was any mistake.</summary>
    /// <exception cref="SceneFileException">There was.</exception>
    public void ThrowIfMistaken()
    {
        if (_mistakes.Count + _others.Count == 0)
        {
            return;
        }

        List<SceneFileError> sorted = [.. _mistakes.OrderBy(mistake => mistake.Line).ThenBy(mistake => mistake.Column)];
        if (_unlisted > 0)
        {
            sorted.Add(sorted[^1] with { Message = $"and {_unlisted} more mistakes", Allowed = null });
        }

        throw new SceneFileException([.. sorted, .. _others]);
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
