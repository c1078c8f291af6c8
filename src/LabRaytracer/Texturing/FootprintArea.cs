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

        if ((_ax * _by) - (_ay * _bx) < 0)
        {
            // Corners go round counter-clockwise, so that areas are above 0.
            (_ax, _ay, _bx, _by) = (_bx, _by, _ax, _ay);
        }
    }

    /// <summary>The mean of a bilinear picture.</summary>
    /// <param name="texels">The texels.</param>
    public Intensity Mean<TTexels>(in TTexels texels)
        where TTexels : struct, IAreaTexels
    {
        Span<(double X, double Y)> corners =
        [
            (_x - (0.5 * (_ax + _bx)), _y - (0.5 * (_ay + _by))), (_x + (0.5 * (_ax - _bx)), _y + (0.5 * (_ay - _by))),
            (_x + (0.5 * (_ax + _bx)), _y + (0.5 * (_ay + _by))), (_x - (0.5 * (_ax - _bx)), _y - (0.5 * (_ay - _by))),
        ];
        ClippedPolygon whole = new(corners);
        Span<(double X, double Y)> stripCorners = stackalloc (double, double)[4 + ClippedPolygon.MoreCorners];
        Span<(double X, double Y)> cellCorners = stackalloc (double, double)[4 + (2 * ClippedPolygon.MoreCorners)];
        (double low, double high) = whole.Range(isY: true);
        ColorSum sum = default;
        for (int row = (int)Math.Floor(low); row < high; row++)
        {
            ClippedPolygon strip = whole.Cut(row, isY: true, stripCorners);
            (double left, double right) = strip.Range(isY: false);
            (int first, int end) = WholeCells(strip, row);
            sum.AddCells(texels, row, first, end);
            for (int column = (int)Math.Floor(left); column < right; column++)
            {
                column = column == first ? end : column;
                sum.AddPart(texels, row, column, strip.Cut(column, isY: false, cellCorners).Moments(column, row));
            }
        }

        return sum.Mean;
    }

    /// <summary>The cells of a row that lie wholly inside: of a convex polygon, those inside of where it meets the lines below and above the row.</summary>
    private static (int First, int End) WholeCells(ClippedPolygon strip, int row)
    {
        (double left0, double right0) = strip.At(row);
        (double left1, double right1) = strip.At(row + 1.0);
        double first = Math.Ceiling(Math.Max(left0, left1)), end = Math.Floor(Math.Min(right0, right1));
        return first < end ? ((int)first, (int)end) : (int.MaxValue, int.MaxValue);
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

    /// <summary>The integral of a bilinear picture over cells and parts of them.</summary>
    private struct ColorSum
    {
        private double _red, _green, _blue, _area;

        /// <summary>The mean over what was added.</summary>
        public readonly Intensity Mean => new((float)(_red / _area), (float)(_green / _area), (float)(_blue / _area));

        /// <summary>Adds whole cells of a row, over each of which the mean is that of its four texels.</summary>
        public void AddCells<TTexels>(in TTexels texels, int row, int first, int end)
            where TTexels : struct, IAreaTexels
        {
            // Of the periods of a picture that is repeated, one stands for all.
            int periods = (end - first) / texels.Period, start = first + (periods * texels.Period);
            AddRun(texels, row, first, periods > 0 ? first + texels.Period : first, periods);
            AddRun(texels, row, start, end, 1);
            _area += end - first;
        }

        private void AddRun<TTexels>(in TTexels texels, int row, int first, int end, int times)
            where TTexels : struct, IAreaTexels
        {
            for (int column = first; column <= end && first < end; column++)
            {
                double weight = column == first || column == end ? 0.25 * times : 0.5 * times;
                Add(texels.At(column, row), weight);
                Add(texels.At(column, row + 1), weight);
            }
        }

        /// <summary>Adds a part of a cell, told by its integrals of 1, x, y and x y.</summary>
        public void AddPart<TTexels>(in TTexels texels, int row, int column, (double One, double X, double Y, double XY) moments)
            where TTexels : struct, IAreaTexels
        {
            (double one, double x, double y, double xy) = moments;
            Add(texels.At(column, row), one - x - y + xy);
            Add(texels.At(column + 1, row), x - xy);
            Add(texels.At(column, row + 1), y - xy);
            Add(texels.At(column + 1, row + 1), xy);
            _area += one;
        }

        private void Add(Intensity color, double weight)
        {
            _red += weight * color.R;
            _green += weight * color.G;
            _blue += weight * color.B;
        }
    }
}
