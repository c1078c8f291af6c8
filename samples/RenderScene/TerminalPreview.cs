using LabRaytracer;
using Spectre.Console;

namespace RenderScene;

/// <summary>Draws a small picture in a terminal: two pixels, one above the other, in each character.</summary>
internal static class TerminalPreview
{
    private const string UpperHalf = "\u2580";

    // The summary and the next prompt should not push the picture out of sight.
    private const int RowsForText = 4;

    /// <summary>Draws a picture file, or says in one line why not.</summary>
    /// <param name="path">The file: what it shows is what is drawn.</param>
    /// <param name="console">Where.</param>
    public static void Show(string path, AppConsole console)
    {
        PreviewScreen screen = console.Screen();
        try
        {
            if (screen.Terminal is { } terminal)
            {
                Draw(Picture.Load(path), terminal);
            }
            else
            {
                console.Error.WriteLine($"no preview: {screen.Refusal}.");
            }
        }
        catch (Exception failure) when (failure is PictureFormatException or OutOfMemoryException)
        {
            // The picture is written all the same, only too large to be read as a whole.
            console.Error.WriteLine($"no preview: {failure.Message}");
        }
    }

    /// <summary>Draws a picture as large as the terminal allows, never enlarged.</summary>
    /// <param name="picture">The picture, linear; clamped to [0, 1].</param>
    /// <param name="terminal">Where.</param>
    public static void Draw(Picture picture, IAnsiConsole terminal)
    {
        Color[,] pixels = Shrink(picture, terminal.Profile.Width, 2 * Math.Max(1, terminal.Profile.Height - RowsForText));
        int width = pixels.GetLength(0), height = pixels.GetLength(1);
        for (int y = 0; y < height; y += 2)
        {
            Paragraph line = new();
            for (int x = 0; x < width; x++)
            {
                line.Append(UpperHalf, new Style(pixels[x, y], y + 1 < height ? pixels[x, y + 1] : Color.Default));
            }

            terminal.Write(line);
            terminal.WriteLine();
        }
    }

    /// <summary>Means of the displayed light over rectangles of pixels.</summary>
    /// <returns>Display colours [x, y], y down.</returns>
    private static Color[,] Shrink(Picture picture, int mostColumns, int mostRows)
    {
        double scale = Math.Min(1, Math.Min((double)mostColumns / picture.Width, (double)mostRows / picture.Height));
        int width = Math.Max(1, (int)(picture.Width * scale)), height = Math.Max(1, (int)(picture.Height * scale));
        Color[,] colors = new Color[width, height];
        for (int y = 0; y < height; y++)
        {
            int top = First(y, picture.Height, height), bottom = First(y + 1, picture.Height, height);
            for (int x = 0; x < width; x++)
            {
                colors[x, y] = Mean(picture, First(x, picture.Width, width), First(x + 1, picture.Width, width), top, bottom);
            }
        }

        return colors;
    }

    private static int First(int cell, int size, int cells) => (int)((long)cell * size / cells);

    private static Color Mean(Picture picture, int left, int right, int top, int bottom)
    {
        Intensity sum = Intensity.Black;
        for (int y = top; y < bottom; y++)
        {
            foreach (Intensity light in picture.Row(y)[left..right])
            {
                sum += ToneMapping.Default.Apply(light);
            }
        }

        Intensity mean = sum * (1f / ((right - left) * (bottom - top)));
        return new Color(ColorEncoding.Srgb8FromLinear(mean.R), ColorEncoding.Srgb8FromLinear(mean.G), ColorEncoding.Srgb8FromLinear(mean.B));
    }
}
