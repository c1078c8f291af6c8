namespace LabRaytracer;

/// <summary>Reflected and refracted rays that wait for their turn. They lie where they arose, and are taken in the order of the rays that they come from.</summary>
/// <param name="hasDifferentials">Whether the rays carry differentials.</param>
internal sealed class SecondaryQueue(bool hasDifferentials)
{
    private SecondaryRay[] _rays = new SecondaryRay[1024];
    private RayDifferential[] _differentials = new RayDifferential[hasDifferentials ? 1024 : 0];
    private int[] _order = new int[1024];
    private int _arisen;

    /// <summary>Number of rays in their order.</summary>
    public int Count { get; private set; }

    /// <summary>One ray in its order.</summary>
    public ref readonly SecondaryRay this[int ray] => ref _rays[_order[ray]];

    /// <summary>How one ray in its order changes from sample to sample; only known if rays carry differentials.</summary>
    public ref readonly RayDifferential Differential(int ray) => ref _differentials[_order[ray]];

    /// <summary>Makes room for a ray.</summary>
    /// <returns>Its place.</returns>
    public int Arise()
    {
        if (_arisen == _rays.Length)
        {
            Array.Resize(ref _rays, 2 * _arisen);
            Array.Resize(ref _order, 2 * _arisen);
            Array.Resize(ref _differentials, 2 * _differentials.Length);
        }

        return _arisen++;
    }

    /// <summary>The ray at a place, to be written.</summary>
    public ref SecondaryRay At(int place) => ref _rays[place];

    /// <summary>How the ray at a place changes from sample to sample, to be written; only if rays carry differentials.</summary>
    public ref RayDifferential DifferentialAt(int place) => ref _differentials[place];

    /// <summary>The ray at a place is the next one in the order.</summary>
    public void Line(int place) => _order[Count++] = place;

    /// <summary>Forgets all rays, keeps the memory.</summary>
    public void Clear() => Count = _arisen = 0;
}
