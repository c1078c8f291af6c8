namespace LabRaytracer;

/// <summary>Columns of linear colours.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
internal unsafe struct ColorColumns<F>
    where F : unmanaged, IReal<F>
{
    /// <summary>Red, green and blue, linear.</summary>
    public F* R, G, B;

    /// <summary>New columns.</summary>
    public ColorColumns(LaneMemory memory, int capacity)
    {
        R = memory.Column<F>(capacity, F.Width);
        G = memory.Column<F>(capacity, F.Width);
        B = memory.Column<F>(capacity, F.Width);
    }

    /// <summary>Writes one colour.</summary>
    public readonly void Put(int element, Intensity color)
    {
        ((float*)R)[element] = color.R;
        ((float*)G)[element] = color.G;
        ((float*)B)[element] = color.B;
    }

    /// <summary>Reads one colour.</summary>
    public readonly Intensity Take(int element) => new(((float*)R)[element], ((float*)G)[element], ((float*)B)[element]);
}
