namespace LabRaytracer;

/// <summary>The things of a section of a scene file that have names: each is read once, in the order of the file or sooner where another one names it.</summary>
internal sealed class NamedThings<T>
    where T : class
{
    /// <summary>Most things that are read one inside the other.</summary>
    public const int MostNested = 100;

    private readonly Dictionary<string, Func<T?>> _open = new(StringComparer.Ordinal);
    private readonly Dictionary<string, T?> _read = new(StringComparer.Ordinal);
    private readonly List<string> _names = [];
    private readonly List<string> _inWork = [];

    /// <summary>The names that a thing may use here, in the order of the file: not those that are being read, which would need themselves.</summary>
    public IEnumerable<string> Usable => _names.Except(_inWork, StringComparer.Ordinal);

    /// <summary>Tells whether the section has no name at all.</summary>
    public bool IsEmpty => _names.Count == 0;

    /// <summary>Tells whether too many things are being read, each for the one before.</summary>
    public bool IsTooDeep => _inWork.Count >= MostNested;

    /// <summary>The things without those that have a mistake in them, in the order of the file.</summary>
    public IEnumerable<KeyValuePair<string, T>> Good => _names.Where(name => Read(name) is not null).Select(name => KeyValuePair.Create(name, _read[name]!));

    /// <summary>Makes a thing known; of two with the same name, which is a mistake of the file, the first one.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="read">Reads it; null if it has a mistake.</param>
    public void Add(string name, Func<T?> read)
    {
        if (!Has(name))
        {
            _names.Add(name);
            _open.Add(name, read);
        }
    }

    /// <summary>Tells whether there is such a thing, read or not.</summary>
    public bool Has(string name) => _open.ContainsKey(name) || _read.ContainsKey(name) || _inWork.Contains(name);

    /// <summary>How a thing that is being read leads back to itself, such as "a -> b -> a"; null of one that is not being read.</summary>
    public string? FindCircle(string name)
    {
        int start = _inWork.IndexOf(name);
        return start < 0 ? null : string.Join(" -> ", _inWork.Skip(start).Append(name).Select(Wording.Name));
    }

    /// <summary>The thing, which is there and is not being read; null if it has a mistake, which was reported where it is described.</summary>
    public T? Read(string name)
    {
        if (_open.Remove(name, out Func<T?>? read))
        {
            _inWork.Add(name);
            _read[name] = read();
            _inWork.RemoveAt(_inWork.Count - 1);
        }

        return _read[name];
    }
}
