using System.Numerics;
using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>Undoes the row filters of PNG (PNG specification, section 9), in place.</summary>
internal static class PngUnfilter
{
    /// <summary>Restores one row.</summary>
    /// <param name="filter">Filter type, 0..4.</param>
    /// <param name="row">The filtered bytes; replaced by the real ones.</param>
    /// <param name="above">The real bytes of the row above, or zeros.</param>
    /// <param name="distance">Bytes of a pixel, at least 1.</param>
    /// <returns>False if there is no such filter.</returns>
    public static bool Apply(byte filter, Span<byte> row, ReadOnlySpan<byte> above, int distance)
    {
        above = above[..row.Length];
        switch (filter)
        {
            case 0:
                return true;
            case 1:
                Sub(row, distance);
                return true;
            case 2:
                Up(row, above);
                return true;
            case 3:
                Average(row, above, distance);
                return true;
            case 4:
                Paeth(row, above, distance);
                return true;
            default:
                return false;
        }
    }

    private static void Sub(Span<byte> row, int distance)
    {
        if (distance == 3)
        {
            int a0 = 0;
            int a1 = 0;
            int a2 = 0;
            foreach (ref Rgb pixel in MemoryMarshal.Cast<byte, Rgb>(row))
            {
                a0 += pixel.R;
                a1 += pixel.G;
                a2 += pixel.B;
                pixel = new Rgb((byte)a0, (byte)a1, (byte)a2);
            }

            return;
        }

        for (int i = distance; i < row.Length; i++)
        {
            row[i] += row[i - distance];
        }
    }

    private static void Up(Span<byte> row, ReadOnlySpan<byte> above)
    {
        int i = 0;
        for (; i <= row.Length - Vector<byte>.Count; i += Vector<byte>.Count)
        {
            (new Vector<byte>(row[i..]) + new Vector<byte>(above[i..])).CopyTo(row[i..]);
        }

        for (; i < row.Length; i++)
        {
            row[i] += above[i];
        }
    }

    private static void Average(Span<byte> row, ReadOnlySpan<byte> above, int distance)
    {
        if (distance == 3)
        {
            Rgb a = default;
            ReadOnlySpan<Rgb> upper = MemoryMarshal.Cast<byte, Rgb>(above);
            Span<Rgb> pixels = MemoryMarshal.Cast<byte, Rgb>(row);
            for (int x = 0; x < pixels.Length; x++)
            {
                Rgb b = upper[x];
                ref Rgb pixel = ref pixels[x];
                a = new Rgb(
                    (byte)(pixel.R + ((a.R + b.R) >> 1)),
                    (byte)(pixel.G + ((a.G + b.G) >> 1)),
                    (byte)(pixel.B + ((a.B + b.B) >> 1)));
                pixel = a;
            }

            return;
        }

        for (int i = 0; i < row.Length; i++)
        {
            int left = i >= distance ? row[i - distance] : 0;
            row[i] += (byte)((left + above[i]) >> 1);
        }
    }

    private static void Paeth(Span<byte> row, ReadOnlySpan<byte> above, int distance)
    {
        if (distance == 3)
        {
            PaethRgb(MemoryMarshal.Cast<byte, Rgb>(row), MemoryMarshal.Cast<byte, Rgb>(above));
            return;
        }

        for (int i = 0; i < row.Length; i++)
        {
            bool first = i < distance;
            int left = first ? 0 : row[i - distance];
            int upperLeft = first ? 0 : above[i - distance];
            row[i] += (byte)Predict(left, above[i], upperLeft);
        }
    }

    /// <summary>The usual case with the three channels' chains side by side.</summary>
    private static void PaethRgb(Span<Rgb> row, ReadOnlySpan<Rgb> above)
    {
        Rgb a = default;
        Rgb c = default;
        above = above[..row.Length];
        for (int x = 0; x < row.Length; x++)
        {
            Rgb b = above[x];
            ref Rgb pixel = ref row[x];
            a = new Rgb(
                (byte)(pixel.R + Predict(a.R, b.R, c.R)),
                (byte)(pixel.G + Predict(a.G, b.G, c.G)),
                (byte)(pixel.B + Predict(a.B, b.B, c.B)));
            pixel = a;
            c = b;
        }
    }

    /// <summary>Whichever of left, above and upper left is nearest to left + above - upper left; without branches, which noise would mispredict.</summary>
    private static int Predict(int left, int above, int upperLeft)
    {
        int p = above - upperLeft;
        int q = left - upperLeft;
        int distanceLeft = Magnitude(p);
        int distanceAbove = Magnitude(q);
        int distanceUpperLeft = Magnitude(p + q);
        int aboveIsNearer = (distanceAbove - distanceLeft) >> 31;
        int best = left ^ ((left ^ above) & aboveIsNearer);
        int distance = distanceLeft + ((distanceAbove - distanceLeft) & aboveIsNearer);
        int upperLeftIsNearer = (distanceUpperLeft - distance) >> 31;
        return best ^ ((best ^ upperLeft) & upperLeftIsNearer);
    }

    private static int Magnitude(int value)
    {
        int sign = value >> 31;
        return (value ^ sign) - sign;
    }

    [StructLayout(LayoutKind.Sequential, Pack = 1)]
    private readonly record struct Rgb(byte R, byte G, byte B);
}
