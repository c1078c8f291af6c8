namespace LabRaytracer;

/// <summary>Reads whole rows of a picture as linear colour, one column of floats a channel.</summary>
internal abstract unsafe class TexelRows
{
    /// <summary>Number of columns.</summary>
    public abstract int Width { get; }

    /// <summary>Number of rows.</summary>
    public abstract int Height { get; }

    /// <summary>Reads one row.</summary>
    /// <param name="y">Row, up, [0, height).</param>
    /// <param name="red">Receives red.</param>
    /// <param name="green">Receives green.</param>
    /// <param name="blue">Receives blue.</param>
    public abstract void Read(int y, float* red, float* green, float* blue);
}
