using LabRaytracer;

namespace RenderScene;

/// <summary>Draws smooth lines, dots and labels into a picture. Pixel (x, y) covers [x, x + 1) x [y, y + 1), y down.</summary>
internal sealed class Canvas
{
    /// <summary>A picture of one colour to draw on.</summary>
    public Canvas(int width, int height, Intensity paper)
    {
        Picture = new Picture(width, height);
        Picture.Pixels.Fill(paper);
    }

    /// <summary>What has been drawn.</summary>
    public Picture Picture { get; }

    /// <summary>Colour of lines and letters that follow.</summary>
    public Intensity Ink { get; set; } = new(0.01f, 0.012f, 0.02f);

    /// <summary>Puts a picture onto this one.</summary>
    public void Paste(Picture part, int left, int top)
    {
        for (int y = 0; y < part.Height; y++)
        {
            part.Row(y).CopyTo(Picture.Row(top + y)[left..]);
        }
    }

    /// <summary>Draws a texture flat: u to the right, v up, one look-up in the middle of each pixel.</summary>
    public void Flat(ITexture texture, int left, int top, int width, int height)
    {
        for (int y = 0; y < height; y++)
        {
            for (int x = 0; x < width; x++)
            {
                Picture[left + x, top + y] = texture.Sample(TextureLookup.At((x + 0.5) / width, 1 - ((y + 0.5) / height)));
            }
        }
    }

    /// <summary>A line with round ends.</summary>
    public void Line(double x0, double y0, double x1, double y1, double width = 2)
    {
        double reach = (width / 2) + 1, length = ((x1 - x0) * (x1 - x0)) + ((y1 - y0) * (y1 - y0));
        int bottom = (int)Math.Min(Picture.Height - 1, Math.Max(y0, y1) + reach), right = (int)Math.Min(Picture.Width - 1, Math.Max(x0, x1) + reach);
        for (int y = (int)Math.Max(0, Math.Min(y0, y1) - reach); y <= bottom; y++)
        {
            for (int x = (int)Math.Max(0, Math.Min(x0, x1) - reach); x <= right; x++)
            {
                double dx = x + 0.5 - x0, dy = y + 0.5 - y0;
                double along = length > 0 ? Math.Clamp(((dx * (x1 - x0)) + (dy * (y1 - y0))) / length, 0, 1) : 0;
                dx -= along * (x1 - x0);
                dy -= along * (y1 - y0);
                double covered = Math.Clamp((width / 2) + 0.5 - Math.Sqrt((dx * dx) + (dy * dy)), 0, 1);
                Picture[x, y] = Intensity.Lerp(Picture[x, y], Ink, (float)covered);
            }
        }
    }

    /// <summary>A line with a head at its end.</summary>
    public void Arrow(double x0, double y0, double x1, double y1, double width = 2)
    {
        double length = Math.Sqrt(((x1 - x0) * (x1 - x0)) + ((y1 - y0) * (y1 - y0))), head = 5 * width;
        double ax = (x1 - x0) / length * head, ay = (y1 - y0) / length * head;
        Line(x0, y0, x1, y1, width);
        Line(x1, y1, x1 - ax - (ay / 2), y1 - ay + (ax / 2), width);
        Line(x1, y1, x1 - ax + (ay / 2), y1 - ay - (ax / 2), width);
    }

    /// <summary>A line through several points.</summary>
    public void Path(IEnumerable<(double X, double Y)> points, double width = 2)
    {
        (double X, double Y)? last = null;
        foreach ((double x, double y) in points)
        {
            if (last is { } from)
            {
                Line(from.X, from.Y, x, y, width);
            }

            last = (x, y);
        }
    }

    /// <summary>A round spot.</summary>
    public void Dot(double x, double y, double diameter) => Line(x, y, x, y, diameter);

    /// <summary>The outline of a rectangle.</summary>
    public void Frame(double left, double top, double width, double height, double line = 2) => Path(
        [(left, top), (left + width, top), (left + width, top + height), (left, top + height), (left, top)], line);

    /// <summary>A label whose middle is at x and whose letters stand on the baseline y.</summary>
    /// <param name="text">Lower-case letters, digits, a few signs; an underscore before a subscript.</param>
    /// <param name="x">Middle of the text.</param>
    /// <param name="baseline">Baseline.</param>
    /// <param name="size">Height of digits, pixels.</param>
    public void Label(string text, double x, double baseline, double size)
    {
        double unit = size / StrokeFont.CapHeight, left = x - (unit * StrokeFont.Width(text) / 2);
        foreach ((double x0, double y0, double x1, double y1) in StrokeFont.Lines(text))
        {
            Line(left + (unit * x0), baseline - (unit * y0), left + (unit * x1), baseline - (unit * y1), Math.Max(1.2, 0.75 * unit));
        }
    }
}
