namespace LabRaytracer;

/// <summary>Finds the pixels of a tile that lie beside a seam of the default mapping.</summary>
/// <remarks>The neighbours of every pixel are traced with it, those beyond the tile too: so what is marked depends neither on tiles nor on crops.</remarks>
internal sealed class SeamMarks
{
    private const double LeastJump = 0.5;

    private readonly int[][] _objects;
    private readonly double[][] _u;

    /// <param name="pixels">Pixels of a tile.</param>
    public SeamMarks(int pixels)
    {
        _objects = [.. Places.Select(_ => new int[pixels])];
        _u = [.. Places.Select(_ => new double[pixels])];
    }

    /// <summary>The pixel itself, then its neighbours to the right, left, below and above, in pixels.</summary>
    public static IReadOnlyList<(int X, int Y)> Places { get; } = [(0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)];

    /// <summary>Numbers of the objects that are seen at a place of each pixel; to be filled.</summary>
    public int[] Objects(int place) => _objects[place];

    /// <summary>u of the default mapping at a place of each pixel, where an object is seen; to be filled.</summary>
    public double[] U(int place) => _u[place];

    /// <summary>Tells whether u jumps between a pixel and a neighbour on the same object.</summary>
    /// <param name="pixel">Number of the pixel in the tile.</param>
    /// <param name="missed">The object number that stands for none.</param>
    public bool IsSeam(int pixel, int missed)
    {
        int seen = _objects[0][pixel];
        for (int place = 1; place < _objects.Length && seen != missed; place++)
        {
            if (_objects[place][pixel] == seen && Math.Abs(_u[place][pixel] - _u[0][pixel]) > LeastJump)
            {
                return true;
            }
        }

        return false;
    }
}
