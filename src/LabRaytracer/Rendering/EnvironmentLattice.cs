namespace LabRaytracer;

/// <summary>Cells of a table of the sky, and the points at which each is looked at.</summary>
/// <param name="Columns">Cells around.</param>
/// <param name="Rows">Cells from pole to pole.</param>
/// <param name="Points">Points across a cell.</param>
/// <param name="Lines">Lines of points in a cell.</param>
/// <param name="Even">Share of samples that are drawn evenly, because the points may miss light.</param>
internal readonly record struct EnvironmentLattice(int Columns, int Rows, int Points, int Lines, double Even)
{
    private const int MostColumns = 1024, MostRows = 512, LeastColumns = 64, LeastRows = 32, MostPoints = 8;

    /// <summary>The cells of a radiance.</summary>
    /// <remarks>
    /// Lat-long pictures have two by two points in the quarters of each texel: their mean is the exact mean of nearest and bilinear lookups over the texel,
    /// and 0 only where these are 0 throughout.
    /// </remarks>
    public static EnvironmentLattice Of(TextureSlot radiance)
    {
        if (radiance.Texture is not Texture picture)
        {
            return new EnvironmentLattice(512, 256, 2, 2, 1.0 / 16);
        }

        bool isLatLong = radiance.Mapping is null or SphericalMapping && radiance.Transform.IsIdentity;
        int width = isLatLong ? picture.Width : Math.Max(picture.Width, picture.Height), height = isLatLong ? picture.Height : width;
        int columns = Cells(width, LeastColumns, MostColumns), rows = Cells(height, LeastRows, MostRows);
        bool fits = isLatLong && radiance.Layers.Count == 0 && Fits(width, columns) && Fits(height, rows) && picture.Sampling.Texels == TexelConvention.Center;
        return new EnvironmentLattice(columns, rows, PointsOf(width, columns), PointsOf(height, rows), fits ? 0 : 1.0 / 16);
    }

    /// <summary>Cells for a number of texels: a part of a texel each, a texel, or several.</summary>
    private static int Cells(int texels, int least, int most)
    {
        int merged = (texels + most - 1) / most;
        return texels < least ? texels * ((least + texels - 1) / texels) : (texels + merged - 1) / merged;
    }

    private static int PointsOf(int texels, int cells) => Math.Clamp(((2 * texels) + cells - 1) / cells, 2, MostPoints);

    private static bool Fits(int texels, int cells) => cells % texels == 0 || (texels % cells == 0 && 2 * texels <= MostPoints * cells);
}
