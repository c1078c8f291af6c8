namespace LabRaytracer.Validation;

/// <summary>Scalars in memory, seen as lanes of a type.</summary>
internal sealed unsafe class Column<R>(int count) : IDisposable
    where R : unmanaged, IReal<R>
{
    private readonly LaneMemory _memory = new();
    private R* _lanes;

    /// <summary>The lanes.</summary>
    public R* Lanes => _lanes == null ? _lanes = _memory.Column<R>(count, R.Width) : _lanes;

    /// <summary>One scalar.</summary>
    public double this[int element]
    {
        get => Lane.Take(Lanes, element);
        set => Lane.Put(Lanes, element, value);
    }

    public void Dispose() => _memory.Dispose();
}
