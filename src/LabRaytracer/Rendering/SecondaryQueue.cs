namespace LabRaytracer;

/// <summary>Reflected and refracted rays that wait for their turn, in the order in which they arose.</summary>
/// <param name="hasDifferentials">Whether the rays carry differentials.</param>
internal sealed class SecondaryQueue(bool hasDifferentials)
{
    private SecondaryRay[] _rays = new SecondaryRay[1024];
    private readonly List<RayDifferential> _differentials = [];

    /// <summary>Number of rays.</summary>
    public int Count { get; private set; }

    /// <summary>One ray.</summary>
    public ref readonly SecondaryRay this[int ray] => ref _rays[ray];

    /// <summary>How one ray changes from sample to sample; only known if rays carry differentials.</summary>
    public RayDifferential Differential(int ray) => _differentials[ray];

    /// <summary>Adds a ray.</summary>
    public void Add(in SecondaryRay ray)
    {
        if (Count == _rays.Length)
        {
            Array.Resize(ref _rays, 2 * Count);
        }

        _rays[Count++] = ray;
    }

    /// <summary>Adds how the ray that was just added changes; only where rays carry differentials.</summary>
    public void AddChange(in RayDifferential differential)
    {
        if (hasDifferentials)
        {
            _differentials.Add(differential);
        }
    }

    /// <summary>The same from an array, which is not read where rays carry no differentials.</summary>
    public void AddChange(RayDifferential[] differentials, int ray)
    {
        if (hasDifferentials)
        {
            _differentials.Add(differentials[ray]);
        }
    }

    /// <summary>Forgets all rays, keeps the memory.</summary>
    public void Clear()
    {
        Count = 0;
        _differentials.Clear();
    }
}
