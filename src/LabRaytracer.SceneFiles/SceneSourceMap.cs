namespace LabRaytracer;

/// <summary>Tells where parts of a loaded scene stand in its file, so that later failures can name the line.</summary>
/// <remarks>Thread safe once the scene is loaded. Parts are told apart by identity, not by value.</remarks>
public sealed class SceneSourceMap
{
    private readonly Dictionary<object, (SceneSource Source, int Offset)> _places = new(ReferenceEqualityComparer.Instance);
    private readonly string _file;

    internal SceneSourceMap(string file) => _file = file;

    /// <summary>Finds the place of a part.</summary>
    /// <param name="part">A texture, material, scene object, light or camera of the scene.</param>
    /// <param name="location">Where its description starts; of a picture, its file name.</param>
    /// <returns>False if the part is not from the file.</returns>
    public bool TryLocate(object part, out SceneLocation location)
    {
        ArgumentNullException.ThrowIfNull(part);
        bool found = _places.TryGetValue(part, out (SceneSource Source, int Offset) place);
        location = found ? place.Source.Locate(place.Offset) : default;
        return found;
    }

    /// <summary>The exception for a failure that a part causes after loading, such as a picture that cannot be decoded.</summary>
    /// <param name="part">A part of the scene.</param>
    /// <param name="failure">What happened.</param>
    /// <returns>The exception with the place of the part; with line 1, column 1 for a part that is not from the file.</returns>
    public SceneFileException Explain(object part, Exception failure)
    {
        ArgumentNullException.ThrowIfNull(failure);
        SceneLocation place = TryLocate(part, out SceneLocation location) ? location : new SceneLocation(_file, 1, 1);
        return new SceneFileException(new SceneFileError(place, Wording.Reason(failure)), failure);
    }

    /// <summary>All pictures that the file, or a file that it names, names, in the order of reading.</summary>
    internal IEnumerable<(Texture Picture, SceneLocation Location)> Pictures =>
        _places.Where(place => place.Key is Texture).Select(place => ((Texture)place.Key, place.Value.Source.Locate(place.Value.Offset)));

    /// <summary>Notes where a part stands; the first place counts.</summary>
    internal void Note(object part, SceneSource source, int offset) => _places.TryAdd(part, (source, offset));

    /// <summary>Takes over the places of a file that the scene names.</summary>
    internal void Add(SceneSourceMap other)
    {
        foreach ((object part, (SceneSource Source, int Offset) place) in other._places)
        {
            _places.TryAdd(part, place);
        }
    }
}
