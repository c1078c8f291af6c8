namespace LabRaytracer;

/// <summary>A rectangle of pixels of a picture.</summary>
/// <param name="X">Leftmost column, at least 0.</param>
/// <param name="Y">Top row, at least 0.</param>
/// <param name="Width">Columns, at least 1.</param>
/// <param name="Height">Rows, at least 1.</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct PixelRectangle(int X, int Y, int Width, int Height);
