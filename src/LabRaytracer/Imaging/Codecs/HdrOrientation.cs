using System.Globalization;

namespace LabRaytracer;

/// <summary>The resolution line of a Radiance picture, such as "-Y 480 +X 640": which way its lines and pixels run.</summary>
internal readonly record struct HdrOrientation(int Width, int Height, bool LinesAreRows, bool LinesReversed, bool PixelsReversed)
{
    /// <summary>Lines in the file.</summary>
    public int Lines => LinesAreRows ? Height : Width;

    /// <summary>Pixels of a line.</summary>
    public int LineLength => LinesAreRows ? Width : Height;

    /// <summary>Reads the resolution line.</summary>
    /// <exception cref="PictureFormatException">The line is none, or the size is over a limit.</exception>
    public static HdrOrientation Parse(PictureInput input, string line, PictureLimits limits, string name)
    {
        string[] words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        bool good = words.Length == 4 && IsAxis(words[0]) && IsAxis(words[2]) && words[0][1] != words[2][1];
        int first = 0;
        int second = 0;
        good = good && TryParse(words[1], out first) && TryParse(words[3], out second);
        if (!good)
        {
            throw input.Bad($"the resolution line '{line}' is none; '-Y 480 +X 640' would be one");
        }

        bool rows = words[0][1] == 'Y';
        (int width, int height) = rows ? (second, first) : (first, second);
        limits.Check(width, height, name);

        // Y grows upwards in this format, rows of a picture grow downwards: +Y is the reversed direction, as is -X.
        return new HdrOrientation(width, height, rows, IsReversed(words[0]), IsReversed(words[2]));
    }

    /// <summary>Index of a pixel in rows from the top.</summary>
    public int PixelIndex(int line, int pixel)
    {
        int alongLines = LinesReversed ? Lines - 1 - line : line;
        int alongPixels = PixelsReversed ? LineLength - 1 - pixel : pixel;
        return LinesAreRows ? (alongLines * Width) + alongPixels : (alongPixels * Width) + alongLines;
    }

    private static bool IsAxis(string word) => word is "-Y" or "+Y" or "-X" or "+X";

    private static bool IsReversed(string axis) => axis is "+Y" or "-X";

    private static bool TryParse(string word, out int value) =>
        int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out value);
}
