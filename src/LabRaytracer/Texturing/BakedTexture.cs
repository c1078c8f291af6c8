namespace LabRaytracer;

/// <summary>A texture turned into texels, and how far it is from the original.</summary>
/// <param name="Texture">The texels: <see cref="Texture.ColorMap"/>[x, y] is the original's colour at the texel's centre ((x + 1/2) / W, (y + 1/2) / H).</param>
/// <param name="RootMeanSquareError">Root mean square difference of the components of the bilinear lookup and the original over all places that were compared.</param>
/// <param name="LargestError">Largest difference of a component.</param>
/// <param name="Places">Number of places that were compared.</param>
/// <remarks>Immutable, thread safe.</remarks>
public sealed record BakedTexture(Texture Texture, double RootMeanSquareError, double LargestError, long Places)
{
    /// <summary>Samples a texture at the centres of the texels of a picture.</summary>
    /// <param name="source">The texture.</param>
    /// <param name="width">Texels along u, at least 1.</param>
    /// <param name="height">Texels along v, at least 1.</param>
    /// <param name="options">Surface and error grid; null for the defaults.</param>
    /// <returns>The texels, and their error: the bilinear lookup of the texels (repeated in both directions) against the original on a regular grid in every texel.</returns>
    /// <exception cref="ArgumentNullException">There is no texture.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The width or the height is below 1.</exception>
    public static BakedTexture Bake(ITexture source, int width, int height, BakeOptions? options = null)
    {
        ArgumentNullException.ThrowIfNull(source);
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);
        options ??= new BakeOptions();
        Intensity[,] colors = new Intensity[width, height];
        Parallel.For(0, height, y =>
        {
            for (int x = 0; x < width; x++)
            {
                colors[x, y] = source.Sample(Lookup(options, (x + 0.5) / width, (y + 0.5) / height));
            }
        });
        Texture texture = new(colors);
        return Compare(source, texture, options);
    }

    private static TextureLookup Lookup(BakeOptions options, double u, double v)
    {
        TextureCoordinate coordinate = new(u, v);
        SurfacePosition at = options.Surface?.Invoke(coordinate) ?? new SurfacePosition(new Point3D(u, v, 0), new Vector3D(0, 0, 1), coordinate);
        return new TextureLookup(coordinate, at.LocalPoint, at.LocalNormal) { WorldPoint = at.LocalPoint, WorldNormal = at.LocalNormal };
    }

    private static BakedTexture Compare(ITexture source, Texture texture, BakeOptions options)
    {
        // One sum for each row, added in order: the same figure on any number of threads.
        int grid = options.ErrorGrid, rows = texture.Height * grid, columns = texture.Width * grid;
        (double Sum, double Largest)[] found = new (double, double)[rows];
        Parallel.For(0, rows, row =>
        {
            for (int column = 0; column < columns; column++)
            {
                TextureLookup lookup = Lookup(options, (column + 0.5) / columns, (row + 0.5) / rows);
                Intensity difference = texture.Sample(lookup) - source.Sample(lookup);
                found[row].Sum += ((double)difference.R * difference.R) + ((double)difference.G * difference.G) + ((double)difference.B * difference.B);
                found[row].Largest = Math.Max(found[row].Largest, Math.Max(Math.Abs(difference.R), Math.Max(Math.Abs(difference.G), Math.Abs(difference.B))));
            }
        });
        long places = (long)rows * columns;
        double sum = found.Sum(row => row.Sum), largest = places == 0 ? 0 : found.Max(row => row.Largest);
        return new BakedTexture(texture, places == 0 ? 0 : Math.Sqrt(sum / (3.0 * places)), largest, places);
    }
}
