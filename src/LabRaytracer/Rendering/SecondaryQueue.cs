namespace LabRaytracer;

/// <summary>Reflected and refracted rays that wait for their turn, in the order in which they arose.</summary>
/// <param name="hasDifferentials">Whether the rays carry differentials.</param>
internal sealed class SecondaryQueue(bool hasDifferentials)
{
    private readonly List<SecondaryRay> _rays = [];
    private readonly List<RayDifferential> _differentials = [];

    /// <summary>Number of rays.</summary>
    public int Count => _rays.Count;

    /// <summary>One ray.</summary>
    public SecondaryRay this[int ray] => _rays[ray];

    /// <summary>How one ray changes from sample to sample; only known if rays carry differentials.</summary>
    public RayDifferential Differential(int ray) => _differentials[ray];

    /// <summary>Adds a ray.</summary>
    public void Add(in SecondaryRay ray, in RayDifferential differential)
    {
        _rays.Add(ray);
        if (hasDifferentials)
        {
            _differentials.Add(differential);
        }
    }

    /// <summary>Forgets all rays, keeps the memory.</summary>
    public void Clear()
    {
        _rays.Clear();
        _differentials.Clear();
    }
}
