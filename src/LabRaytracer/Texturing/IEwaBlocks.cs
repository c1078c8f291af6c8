namespace LabRaytracer;

/// <summary>Adds up blocks of texels by their weights, four of a row and the four above them.</summary>
internal interface IEwaBlocks
{
    /// <summary>Goes to two rows.</summary>
    /// <param name="y">The lower one, from the row of the centre.</param>
    void Row(int y);

    /// <summary>Adds a block of the two rows.</summary>
    /// <param name="x">Its first column, from the column of the centre.</param>
    /// <param name="weights">Weights of the lower row, then of the upper one.</param>
    /// <param name="sum">One part of the sum.</param>
    /// <param name="other">The other part.</param>
    void Add(int x, Float8 weights, ref Float8 sum, ref Float8 other);

    /// <summary>Red, green, blue and the sum of the weights.</summary>
    /// <param name="sum">One part of the sum.</param>
    /// <param name="other">The other part.</param>
    static abstract Float4 Total(Float8 sum, Float8 other);
}
