namespace LabRaytracer;

/// <summary>The texels that an area is integrated over.</summary>
internal interface IAreaTexels
{
    /// <summary>After how many columns the texels of a row are the same again, above 0; <see cref="int.MaxValue"/> if they never are.</summary>
    int Period { get; }

    /// <summary>Colour of the texel at a column and a row, anywhere.</summary>
    Intensity At(int column, int row);
}
