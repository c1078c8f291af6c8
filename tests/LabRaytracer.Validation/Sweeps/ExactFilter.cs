namespace LabRaytracer.Validation;

/// <summary>Filtered lookups of grey textures in exact arithmetic; texel centres, clamped.</summary>
internal static class ExactFilter
{
    /// <summary>Nearer than this to a line of texel centres, either side's sixteen texels may be taken.</summary>
    private const double Margin = 1e-9;

    /// <summary>The colour at (u, v); null where a mean may be cut to the range of its texels and it is not certain which these are.</summary>
    public static Real? Of(TextureFilter filter, Texture texture, double u, double v)
    {
        (int x, Real right) = Between(u, texture.Width);
        (int y, Real above) = Between(v, texture.Height);
        Real[] columns = Weights(filter, right), rows = Weights(filter, above);
        int first = columns.Length == 4 ? -1 : 0;
        Real mean = 0, low = double.MaxValue, high = -double.MaxValue;
        for (int row = 0; row < rows.Length; row++)
        {
            for (int column = 0; column < columns.Length; column++)
            {
                Real texel = texture.ColorMap[Math.Clamp(x + first + column, 0, texture.Width - 1), Math.Clamp(y + first + row, 0, texture.Height - 1)].R;
                mean += texel * columns[column] * rows[row];
                low = texel < low ? texel : low;
                high = texel > high ? texel : high;
            }
        }

        return filter != TextureFilter.CatmullRom ? mean : !IsSure(right) || !IsSure(above) ? null : mean < low ? low : mean > high ? high : mean;
    }

    /// <summary>Weights of the texels around a point that lies a share t of the way from one centre to the next.</summary>
    private static Real[] Weights(TextureFilter filter, Real t)
    {
        Real square = t * t, cube = square * t, rest = 1 - t;
        return filter switch
        {
            TextureFilter.CatmullRom =>
            [
                Real.Scale((2 * square) - t - cube, -1),
                Real.Scale((3 * cube) - (5 * square) + 2, -1),
                Real.Scale((4 * square) - (3 * cube) + t, -1),
                Real.Scale(cube - square, -1),
            ],
            TextureFilter.BSpline => [rest * rest * rest / 6, ((3 * cube) - (6 * square) + 4) / 6, ((3 * square) - (3 * cube) + (3 * t) + 1) / 6, cube / 6],
            _ => [rest, t],
        };
    }

    private static bool IsSure(Real share) => share > Margin && share < 1 - Margin;

    private static (int First, Real Share) Between(double coordinate, int size)
    {
        Real inside = coordinate < 0 ? 0 : coordinate > 1 ? 1 : coordinate, position = (inside * size) - 0.5;
        int first = (int)Real.Floor(position);
        return (first, position - first);
    }
}
