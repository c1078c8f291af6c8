namespace LabRaytracer;

/// <summary>The numbered grid's exact means over boxes along the axes, and over parallelograms cut into such boxes.</summary>
/// <remarks>
/// <para>Lines, signs and cells are rectangles: the grid is a product of intervals, in each of which it has one colour. Its integral from the corner up to a point (a summed-area table:
/// Crow 1984) is bilinear between the ends of intervals, so the mean over a box is a difference of four interpolated sums, exact but for rounding (below 1e-6).</para>
/// <para>Footprints whose sides lie along the axes are boxes. Others are cut along their longer side into pieces of half a dot, at most 64, each taken for a box of the same extent
/// along each axis; what is neglected is the slant of a piece.</para>
/// <para>24 bytes for each pair of intervals, of which a cell has up to 11 x 11: 0.9 megabytes for 24 x 12 cells. Immutable, thread safe.</para>
/// </remarks>
internal sealed class GridArea
{
    /// <summary>Most pieces of a footprint.</summary>
    private const int MostPieces = 64;

    /// <summary>Least extent of a box, cells; smaller ones would be rounding alone.</summary>
    private const double LeastExtent = 1e-4;

    private readonly GridTexture _grid;
    private readonly int _columns, _rows, _width;
    private readonly double[] _ends;
    private readonly Vector3D[] _sums;

    /// <param name="grid">The grid.</param>
    public GridArea(GridTexture grid)
    {
        _grid = grid;
        (_columns, _rows) = (grid.Columns, grid.Rows);
        double half = grid.LineWidth / 2;
        _ends = [.. Enumerable.Range(0, GridGlyphs.Side + 1).Select(dot => dot / (double)GridGlyphs.Side).Append(half).Append(1 - half).Distinct().Order()];
        int pieces = _ends.Length - 1;
        _width = (_columns * pieces) + 1;
        _sums = new Vector3D[_width * ((_rows * pieces) + 1)];
        for (int j = 0; j < _rows * pieces; j++)
        {
            Vector3D row = default;
            for (int i = 0; i < _columns * pieces; i++)
            {
                (double x, double across) = Interval(i);
                (double y, double up) = Interval(j);
                Intensity color = grid.At(x / _columns, y / _rows, TextureWrap.Repeat);
                row += new Vector3D(color.R, color.G, color.B) * (across * up);
                _sums[((j + 1) * _width) + i + 1] = _sums[(j * _width) + i + 1] + row;
            }
        }
    }

    /// <summary>The mean over the footprint of a lookup; the colour at the point if it has none.</summary>
    /// <param name="u">Centre.</param>
    /// <param name="v">Centre.</param>
    /// <param name="footprint">The footprint, texture units.</param>
    /// <param name="wrapV">What lies beyond the first and the last row.</param>
    public Intensity Mean(double u, double v, in TextureFootprint footprint, TextureWrap wrapV)
    {
        CheckerPoint<Double1> right = new() { U = new(footprint.DuDx * _columns), V = new(footprint.DvDx * _rows) }, down = new() { U = new(footprint.DuDy * _columns), V = new(footprint.DvDy * _rows) };
        CheckerSides<Double1> sides = new(right, down);
        double longU = sides.LongU.Value, longV = sides.LongV.Value, shortU = sides.ShortU.Value, shortV = sides.ShortV.Value;
        double longest = Math.Max(Math.Abs(longU), Math.Abs(longV));
        if (longest < LeastExtent)
        {
            return _grid.At(u, v, wrapV);
        }

        bool isBox = (longU == 0 || longV == 0) && (shortU == 0 || shortV == 0);
        int pieces = isBox ? 1 : (int)Math.Clamp(Math.Ceiling(longest * 2 * GridGlyphs.Side), 1, MostPieces);
        double stepU = longU / pieces, stepV = longV / pieces;
        double halfU = Extent(shortU, stepU) / 2, halfV = Extent(shortV, stepV) / 2;

        // Near the first tile the ends of boxes keep their digits.
        bool isBounded = wrapV is TextureWrap.Clamp or TextureWrap.Pole;
        double x = (u - Math.Floor(u)) * _columns, y = (isBounded ? Math.Clamp(v, 0, 1) : v - Math.Floor(v)) * _rows;
        Vector3D sum = default;
        for (int piece = 0; piece < pieces; piece++)
        {
            double place = piece + 0.5 - (pieces * 0.5), atX = x + (place * stepU), atY = y + (place * stepV);
            (double left, double end) = (atX - halfU, atX + halfU);
            sum += (isBounded ? Bounded(left, end, atY - halfV, atY + halfV, wrapV) : Box(left, end, atY - halfV, atY + halfV)) / (4 * halfU * halfV);
        }

        return new Intensity((float)(sum.X / pieces), (float)(sum.Y / pieces), (float)(sum.Z / pieces));
    }

    private static double Extent(double a, double b) => Math.Max(Math.Sqrt((a * a) + (b * b)), LeastExtent);

    /// <summary>The integral over a box of which parts may lie beyond the first or the last row.</summary>
    private Vector3D Bounded(double left, double right, double bottom, double top, TextureWrap wrapV)
    {
        double low = Math.Clamp(bottom, 0, _rows), high = Math.Clamp(top, 0, _rows);
        Vector3D inside = Box(left, right, low, high);
        (double below, double above) = (low - bottom, top - high);
        if (wrapV == TextureWrap.Pole)
        {
            // The other side of the pole, half a turn away; never farther than the other pole.
            double turn = _columns * 0.5, rows = _rows;
            return inside + Scaled(left + turn, right + turn, 0, Math.Min(below, rows), below) + Scaled(left + turn, right + turn, rows - Math.Min(above, rows), rows, above);
        }

        (_, double edge) = Interval(0);
        return inside + Scaled(left, right, 0, edge, below) + Scaled(left, right, _rows - edge, _rows, above);
    }

    /// <summary>The mean over the rows of a box, times a height.</summary>
    private Vector3D Scaled(double left, double right, double bottom, double top, double height) =>
        height > 0 ? Box(left, right, bottom, top) * (height / (top - bottom)) : default;

    /// <summary>The integral over a box.</summary>
    private Vector3D Box(double left, double right, double bottom, double top)
    {
        Spot x0 = Locate(left, _columns), x1 = Locate(right, _columns), y0 = Locate(bottom, _rows), y1 = Locate(top, _rows);
        return Integral(x1, y1) - Integral(x0, y1) - (Integral(x1, y0) - Integral(x0, y0));
    }

    /// <summary>The integral from the corner to a point, tiles side by side.</summary>
    private Vector3D Integral(in Spot x, in Spot y)
    {
        int right = _width - 1, top = (_sums.Length / _width) - 1;
        Spot endX = new(right - 1, 1, 0), endY = new(top - 1, 1, 0);
        return Within(x, y) + (Within(endX, y) * x.Turns) + (Within(x, endY) * y.Turns) + (Within(endX, endY) * (x.Turns * y.Turns));
    }

    /// <summary>The same inside one tile: bilinear between the ends of intervals.</summary>
    private Vector3D Within(in Spot x, in Spot y)
    {
        int at = (y.Interval * _width) + x.Interval;
        Vector3D low = (_sums[at] * (1 - x.Share)) + (_sums[at + 1] * x.Share);
        Vector3D high = (_sums[at + _width] * (1 - x.Share)) + (_sums[at + _width + 1] * x.Share);
        return (low * (1 - y.Share)) + (high * y.Share);
    }

    /// <summary>Finds the interval of a place.</summary>
    /// <param name="place">The place, cells.</param>
    /// <param name="cells">Cells of a tile.</param>
    private Spot Locate(double place, int cells)
    {
        double turns = Math.Floor(place / cells), rest = Math.Clamp(place - (turns * cells), 0, cells);
        int cell = Math.Min((int)rest, cells - 1), k = 0;
        double inside = rest - cell;
        while (k < _ends.Length - 2 && inside >= _ends[k + 1])
        {
            k++;
        }

        return new Spot((cell * (_ends.Length - 1)) + k, (inside - _ends[k]) / (_ends[k + 1] - _ends[k]), turns);
    }

    /// <summary>Middle and length of an interval, cells.</summary>
    private (double Middle, double Length) Interval(int number)
    {
        int cell = number / (_ends.Length - 1), k = number % (_ends.Length - 1);
        return (cell + ((_ends[k] + _ends[k + 1]) / 2), _ends[k + 1] - _ends[k]);
    }

    /// <summary>A place along an axis.</summary>
    /// <param name="Interval">Its interval in a tile.</param>
    /// <param name="Share">Where in it, [0, 1].</param>
    /// <param name="Turns">Tiles before it.</param>
    private readonly record struct Spot(int Interval, double Share, double Turns);
}
