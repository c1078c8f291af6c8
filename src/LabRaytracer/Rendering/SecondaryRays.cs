namespace LabRaytracer;

/// <summary>The reflected and refracted rays that a batch leaves behind, given back in the order of the rays they come from.</summary>
/// <remarks>
/// The order does not depend on how hits were grouped or batches were cut: so neither does the order in which light is added to a pixel, to the last bit.
/// </remarks>
/// <param name="capacity">Most rays of a batch.</param>
/// <param name="hasDifferentials">Whether rays carry differentials.</param>
internal sealed class SecondaryRays(int capacity, bool hasDifferentials)
{
    private readonly SecondaryRay[] _reflected = new SecondaryRay[capacity];
    private readonly SecondaryRay[] _refracted = new SecondaryRay[capacity];
    private readonly RayDifferential[] _reflectedChange = hasDifferentials ? new RayDifferential[capacity] : [];
    private readonly RayDifferential[] _refractedChange = hasDifferentials ? new RayDifferential[capacity] : [];
    private readonly byte[] _present = new byte[capacity];
    private readonly List<(int Ray, int Turn, SecondaryRay Secondary, RayDifferential Change)> _layers = [];
    private bool _any;

    /// <summary>Keeps the reflected ray of a ray.</summary>
    public void Reflect(int ray, in SecondaryRay secondary)
    {
        _reflected[ray] = secondary;
        _present[ray] |= 1;
        _any = true;
    }

    /// <summary>Keeps the refracted ray of a ray.</summary>
    public void Refract(int ray, in SecondaryRay secondary)
    {
        _refracted[ray] = secondary;
        _present[ray] |= 2;
        _any = true;
    }

    /// <summary>Keeps how the reflected and the refracted ray of a ray change from sample to sample; only where rays carry differentials.</summary>
    public void SetChanges(int ray, in RayDifferential reflected, in RayDifferential refracted)
    {
        _reflectedChange[ray] = reflected;
        _refractedChange[ray] = refracted;
    }

    /// <summary>Sets the rays of one layer of surfaces aside: their places are free for those of the next one.</summary>
    /// <param name="count">Number of rays of the batch.</param>
    public void EndLayer(int count)
    {
        for (int ray = 0; _any && ray < count; ray++)
        {
            if ((_present[ray] & 1) != 0)
            {
                _layers.Add((ray, _layers.Count, _reflected[ray], Change(_reflectedChange, ray)));
            }

            if ((_present[ray] & 2) != 0)
            {
                _layers.Add((ray, _layers.Count, _refracted[ray], Change(_refractedChange, ray)));
            }

            _present[ray] = 0;
        }

        _any = false;
    }

    /// <summary>Moves what was kept to the end of a list.</summary>
    /// <param name="count">Number of rays of the batch.</param>
    /// <param name="queue">The list.</param>
    public void MoveTo(int count, SecondaryQueue queue)
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
                queue.Add(_layers[layer].Secondary);
                queue.AddChange(_layers[layer].Change);
            }

            Move(ray, queue);
        }

        _layers.Clear();
        _any = false;
    }

    private void Move(int ray, SecondaryQueue queue)
    {
        byte present = _present[ray];
        if (present == 0)
        {
            return;
        }

        if ((present & 1) != 0)
        {
            queue.Add(_reflected[ray]);
            queue.AddChange(_reflectedChange, ray);
        }

        if ((present & 2) != 0)
        {
            queue.Add(_refracted[ray]);
            queue.AddChange(_refractedChange, ray);
        }

        _present[ray] = 0;
    }

    private RayDifferential Change(RayDifferential[] changes, int ray) => hasDifferentials ? changes[ray] : default;
}
