namespace LabRaytracer;

/// <summary>A small convex polygon that can be cut to a strip one texel wide.</summary>
/// <param name="corners">Its corners, one after the other.</param>
internal readonly ref struct ClippedPolygon(ReadOnlySpan<(double X, double Y)> corners)
{
    /// <summary>How many corners more a polygon can have once it is cut to a strip.</summary>
    public const int MoreCorners = 4;

    /// <summary>A corner so near to a line lies on it.</summary>
    private const double Near = 1e-9;

    private readonly ReadOnlySpan<(double X, double Y)> _corners = corners;

    /// <summary>Least and largest coordinate; an empty range without corners.</summary>
    public (double Low, double High) Range(bool isY)
    {
        double low = double.PositiveInfinity, high = double.NegativeInfinity;
        foreach ((double x, double y) in _corners)
        {
            low = Math.Min(low, isY ? y : x);
            high = Math.Max(high, isY ? y : x);
        }

        return low <= high ? (low, high) : (0, 0);
    }

    /// <summary>Where along a line across the rows the polygon lies; an empty range, with its ends exchanged, where it does not touch the line.</summary>
    public (double Left, double Right) At(double y)
    {
        double left = double.PositiveInfinity, right = double.NegativeInfinity;
        foreach ((double X, double Y) corner in _corners)
        {
            if (Math.Abs(corner.Y - y) < Near)
            {
                left = Math.Min(left, corner.X);
                right = Math.Max(right, corner.X);
            }
        }

        return (left, right);
    }

    /// <summary>The part with a coordinate in [start, start + 1].</summary>
    /// <param name="start">Where the strip begins.</param>
    /// <param name="isY">Whether the coordinate is y.</param>
    /// <param name="memory">Receives the corners: <see cref="MoreCorners"/> more than there are.</param>
    public ClippedPolygon Cut(int start, bool isY, Span<(double X, double Y)> memory)
    {
        Span<(double X, double Y)> once = stackalloc (double, double)[_corners.Length + (MoreCorners / 2)];
        int count = Cut(_corners, once, start, 1, isY);
        count = Cut(once[..count], memory, -(start + 1), -1, isY);
        return new ClippedPolygon(memory[..count]);
    }

    /// <summary>Integrals of 1, x, y and x y over the polygon, x and y from a corner of its cell.</summary>
    public (double One, double X, double Y, double XY) Moments(int column, int row)
    {
        (double one, double mx, double my, double mxy) = (0, 0, 0, 0);
        for (int k = 2; k < _corners.Length; k++)
        {
            (double x0, double y0) = (_corners[0].X - column, _corners[0].Y - row);
            (double x1, double y1) = (_corners[k - 1].X - column, _corners[k - 1].Y - row);
            (double x2, double y2) = (_corners[k].X - column, _corners[k].Y - row);
            double area = (((x1 - x0) * (y2 - y0)) - ((x2 - x0) * (y1 - y0))) / 2;
            double sumX = x0 + x1 + x2, sumY = y0 + y1 + y2;
            one += area;
            mx += area * sumX / 3;
            my += area * sumY / 3;
            mxy += area * ((sumX * sumY) + (x0 * y0) + (x1 * y1) + (x2 * y2)) / 12;
        }

        return (one, mx, my, mxy);
    }

    /// <summary>The part where sign * coordinate is not below a bound (Sutherland and Hodgman 1974).</summary>
    private static int Cut(ReadOnlySpan<(double X, double Y)> corners, Span<(double X, double Y)> result, double bound, int sign, bool isY)
    {
        int count = 0;
        for (int k = 0; k < corners.Length; k++)
        {
            (double X, double Y) a = corners[k], b = corners[k + 1 < corners.Length ? k + 1 : 0];
            double da = (sign * (isY ? a.Y : a.X)) - bound, db = (sign * (isY ? b.Y : b.X)) - bound;
            if (da >= 0)
            {
                result[count++] = a;
            }

            if (da >= 0 != db >= 0)
            {
                double t = da / (da - db);
                result[count++] = (a.X + (t * (b.X - a.X)), a.Y + (t * (b.Y - a.Y)));
            }
        }

        return count;
    }
}
