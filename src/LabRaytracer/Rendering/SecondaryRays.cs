namespace LabRaytracer;

/// <summary>The reflected and refracted rays that a batch leaves behind, lined up in the order of the rays they come from.</summary>
/// <remarks>
/// The order does not depend on how hits were grouped or batches were cut: so neither does the order in which light is added to a pixel, to the last bit.
/// </remarks>
/// <param name="capacity">Most rays of a batch.</param>
internal sealed class SecondaryRays(int capacity)
{
    private const byte IsReflected = 1, IsRefracted = 2;

    private readonly int[] _reflected = new int[capacity];
    private readonly int[] _refracted = new int[capacity];
    private readonly byte[] _present = new byte[capacity];
    private readonly List<(int Ray, int Turn, int Place)> _layers = [];
    private SecondaryQueue? _queue;
    private bool _any;

    /// <summary>Where the rays are kept, once a batch has been started.</summary>
    public SecondaryQueue Queue => _queue!;

    /// <summary>Starts a batch.</summary>
    /// <param name="queue">Receives the rays.</param>
    public void Start(SecondaryQueue queue) => _queue = queue;

    /// <summary>Makes room for the reflected ray of a ray.</summary>
    /// <returns>Its place in the queue.</returns>
    public int Reflect(int ray)
    {
        _present[ray] |= IsReflected;
        _any = true;
        return _reflected[ray] = Queue.Arise();
    }

    /// <summary>Makes room for the refracted ray of a ray.</summary>
    /// <returns>Its place in the queue.</returns>
    public int Refract(int ray)
    {
        _present[ray] |= IsRefracted;
        _any = true;
        return _refracted[ray] = Queue.Arise();
    }

    /// <summary>Sets the rays of one layer of surfaces aside: the next layer has rays of its own.</summary>
    /// <param name="count">Number of rays of the batch.</param>
    public void EndLayer(int count)
    {
        for (int ray = 0; _any && ray < count; ray++)
        {
            if ((_present[ray] & IsReflected) != 0)
            {
                _layers.Add((ray, _layers.Count, _reflected[ray]));
            }

            if ((_present[ray] & IsRefracted) != 0)
            {
                _layers.Add((ray, _layers.Count, _refracted[ray]));
            }

            _present[ray] = 0;
        }

        _any = false;
    }

    /// <summary>Lines up what was kept.</summary>
    /// <param name="count">Number of rays of the batch.</param>
    public void LineUp(int count)
    {
        if (!_any && _layers.Count == 0)
        {
            return;
        }

        if (_layers.Count > 0)
        {
            _layers.Sort(static (a, b) => (a.Ray, a.Turn).CompareTo((b.Ray, b.Turn)));
        }

        int layer = 0;
        for (int ray = 0; ray < count; ray++)
        {
            for (; layer < _layers.Count && _layers[layer].Ray == ray; layer++)
            {
                Queue.Line(_layers[layer].Place);
            }

            if (_present[ray] != 0)
            {
                LineUpOne(ray);
            }
        }

        _layers.Clear();
        _any = false;
    }

    private void LineUpOne(int ray)
    {
        if ((_present[ray] & IsReflected) != 0)
        {
            Queue.Line(_reflected[ray]);
        }

        if ((_present[ray] & IsRefracted) != 0)
        {
            Queue.Line(_refracted[ray]);
        }

        _present[ray] = 0;
    }
}
