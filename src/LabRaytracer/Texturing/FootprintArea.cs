namespace LabRaytracer;

/// <summary>The parallelogram of a footprint among texel centres, and the exact mean of a bilinear picture over it.</summary>
internal readonly struct FootprintArea
{
    /// <summary>Least width of the parallelogram, texels: a line is integrated as a strip so thin.</summary>
    private const double LeastWidth = 1e-3;

    private readonly double _x, _y, _ax, _ay, _bx, _by;

    /// <param name="x">Centre, where texel centres are integers.</param>
    /// <param name="y">Centre.</param>
    /// <param name="footprint">The footprint, texture units.</param>
    /// <param name="width">Texels of the picture along u.</param>
    /// <param name="height">Texels of the picture along v.</param>
    public FootprintArea(double x, double y, in TextureFootprint footprint, int width, int height)
    {
        (_x, _y) = (x, y);
        (_ax, _ay, _bx, _by) = (footprint.DuDx * width, footprint.DvDx * height, footprint.DuDy * width, footprint.DvDy * height);
        Widen(ref _ax, ref _ay, -_by, _bx);
        Widen(ref _bx, ref _by, -_ay, _ax);
        double area = (_ax * _by) - (_ay * _bx), longest = Math.Max((_ax * _ax) + (_ay * _ay), (_bx * _bx) + (_by * _by));
        if (Math.Abs(area) < LeastWidth * Math.Sqrt(longest))
        {
            // Nearly a line: the second side stands up on the first one.
            double toUnit = LeastWidth / Math.Sqrt((_ax * _ax) + (_ay * _ay));
            (_bx, _by) = (_bx - (_ay * toUnit), _by + (_ax * toUnit));
        }
    }

    /// <summary>The mean of a bilinear picture.</summary>
    /// <param name="texel">Colour of the texel at a column and a row, anywhere.</param>
    public Intensity Mean(Func<int, int, Intensity> texel)
    {
        Span<(double X, double Y)> corners =
        [
            (_x - (0.5 * (_ax + _bx)), _y - (0.5 * (_ay + _by))), (_x + (0.5 * (_ax - _bx)), _y + (0.5 * (_ay - _by))),
            (_x + (0.5 * (_ax + _bx)), _y + (0.5 * (_ay + _by))), (_x - (0.5 * (_ax - _bx)), _y - (0.5 * (_ay - _by))),
        ];
        ClippedPolygon whole = new(corners);
        (double low, double high) = whole.Range(isY: true);
        double red = 0, green = 0, blue = 0, area = 0;
        for (int row = (int)Math.Floor(low); row < high; row++)
        {
            ClippedPolygon strip = whole.Cut(row, isY: true);
            (double left, double right) = strip.Range(isY: false);
            for (int column = (int)Math.Floor(left); column < right; column++)
            {
                (double one, double x, double y, double xy) = strip.Cut(column, isY: false).Moments(column, row);
                (double w00, double w10, double w01, double w11) = (one - x - y + xy, x - xy, y - xy, xy);
                (Intensity c00, Intensity c10, Intensity c01, Intensity c11) = (texel(column, row), texel(column + 1, row), texel(column, row + 1), texel(column + 1, row + 1));
                red += (w00 * c00.R) + (w10 * c10.R) + (w01 * c01.R) + (w11 * c11.R);
                green += (w00 * c00.G) + (w10 * c10.G) + (w01 * c01.G) + (w11 * c11.G);
                blue += (w00 * c00.B) + (w10 * c10.B) + (w01 * c01.B) + (w11 * c11.B);
                area += one;
            }
        }

        return new Intensity((float)(red / area), (float)(green / area), (float)(blue / area));
    }

    /// <summary>Gives a side without length the least one, along a direction or, if that has none either, along an axis.</summary>
    private static void Widen(ref double x, ref double y, double alongX, double alongY)
    {
        double square = (x * x) + (y * y), along = Math.Sqrt((alongX * alongX) + (alongY * alongY));
        if (square < LeastWidth * LeastWidth)
        {
            (x, y) = along > 0 ? (alongX / along * LeastWidth, alongY / along * LeastWidth) : (LeastWidth, 0);
        }
    }
}
