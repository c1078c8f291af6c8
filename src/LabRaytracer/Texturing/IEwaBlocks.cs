namespace LabRaytracer;

/// <summary>Reads blocks of texels, four of a row and the four above them; a texel is red, green, blue, 1.</summary>
internal interface IEwaBlocks
{
    /// <summary>Goes to two rows.</summary>
    /// <param name="y">The lower one, from the row of the centre.</param>
    void Row(int y);

    /// <summary>Reads a block of the two rows.</summary>
    /// <param name="x">Its first column, from the column of the centre.</param>
    /// <param name="lower0">Two texels of the lower row.</param>
    /// <param name="lower2">The next two.</param>
    /// <param name="upper0">Two texels of the upper row.</param>
    /// <param name="upper2">The next two.</param>
    void Read(int x, out Float8 lower0, out Float8 lower2, out Float8 upper0, out Float8 upper2);
}
