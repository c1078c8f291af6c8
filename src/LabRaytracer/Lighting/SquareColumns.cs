namespace LabRaytracer;

/// <summary>Columns of <see cref="SquarePoint"/>.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal unsafe struct SquareColumns<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Coordinates, (0, 1).</summary>
    public R* S, T;

    /// <summary>New columns.</summary>
    public SquareColumns(LaneMemory memory, int capacity)
    {
        S = memory.Column<R>(capacity, R.Width);
        T = memory.Column<R>(capacity, R.Width);
    }
}
