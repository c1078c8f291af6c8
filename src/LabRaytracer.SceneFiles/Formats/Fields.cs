namespace LabRaytracer;

/// <summary>The values of one object of a scene file, by key.</summary>
internal sealed class Fields(SceneNode node, SceneReading reading)
{
    private readonly List<(Key Key, SceneNode Node, object Value)> _values = [];

    /// <summary>The object itself.</summary>
    public SceneNode Node => node;

    public SceneReading Reading => reading;

    /// <summary>Tells whether a mistake was found after all values were read.</summary>
    public bool Failed { get; private set; }

    /// <summary>Keeps a value that was read.</summary>
    public void Add(Key key, SceneNode at, object value) => _values.Add((key, at, value));

    public bool Has(Key key) => Find(key) is not null;

    /// <summary>The value, or the default where the key was left out.</summary>
    public T Get<T>(Key<T> key)
        where T : notnull => Find(key) is { } found ? (T)found.Value : key.Default;

    /// <summary>The value, or null where the key was left out.</summary>
    public T? Find<T>(Key<T> key)
        where T : class => Find((Key)key)?.Value as T;

    /// <summary>The value in the file; the whole object where the key was left out.</summary>
    public SceneNode At(Key key) => Find(key)?.Node ?? node;

    /// <summary>Notes a mistake: the object is not made.</summary>
    public void Fail(Key key, string what, string? allowed = null)
    {
        reading.Mistake(At(key), what, allowed);
        Failed = true;
    }

    /// <summary>Makes something of values that may not fit together.</summary>
    /// <param name="key">The key to blame.</param>
    /// <param name="make">Makes it; throws <see cref="ArgumentException"/> where they do not.</param>
    /// <param name="what">What is wrong then.</param>
    /// <param name="allowed">What would be right.</param>
    /// <returns>Null after a mistake, which is noted: the object is not made.</returns>
    public T? Make<T>(Key key, Func<T> make, string what, string allowed)
        where T : class
    {
        try
        {
            return make();
        }
        catch (ArgumentException)
        {
            Fail(key, what, allowed);
            return null;
        }
    }

    private (Key Key, SceneNode Node, object Value)? Find(Key key)
    {
        foreach ((Key Key, SceneNode Node, object Value) value in _values)
        {
            if (ReferenceEquals(value.Key, key))
            {
                return value;
            }
        }

        return null;
    }
}
