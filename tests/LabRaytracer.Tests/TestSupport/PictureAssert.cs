using System.Runtime.InteropServices;

namespace LabRaytracer.Tests;

/// <summary>Comparison of pictures.</summary>
internal static class PictureAssert
{
    /// <summary>Fails unless two pictures have the same size and the same bits.</summary>
    public static void SameBits(Picture expected, Picture actual)
    {
        Assert.Equal((expected.Width, expected.Height), (actual.Width, actual.Height));
        ReadOnlySpan<int> a = MemoryMarshal.Cast<Intensity, int>(expected.Pixels), b = MemoryMarshal.Cast<Intensity, int>(actual.Pixels);
        int at = a.CommonPrefixLength(b);
        if (at < a.Length)
        {
            int pixel = at / 3;
            (int x, int y) = (pixel % expected.Width, pixel / expected.Width);
            Assert.Fail($"Pixel ({x}, {y}): expected {expected[x, y]}, got {actual[x, y]}.");
        }
    }

    /// <summary>Fails unless every component of two pictures differs by at most a tolerance.</summary>
    public static void Near(Picture expected, Picture actual, double tolerance)
    {
        Assert.Equal((expected.Width, expected.Height), (actual.Width, actual.Height));
        for (int y = 0; y < expected.Height; y++)
        {
            for (int x = 0; x < expected.Width; x++)
            {
                Near(expected[x, y], actual[x, y], tolerance, $"pixel ({x}, {y})");
            }
        }
    }

    /// <summary>Fails unless two colours differ by at most a tolerance in every component.</summary>
    public static void Near(Intensity expected, Intensity actual, double tolerance, string place)
    {
        bool isNear = Math.Abs(expected.R - actual.R) <= tolerance && Math.Abs(expected.G - actual.G) <= tolerance && Math.Abs(expected.B - actual.B) <= tolerance;
        Assert.True(isNear, $"{place}: expected {expected}, got {actual}, allowed difference {tolerance}.");
    }

    /// <summary>Root mean square difference of two pictures, over all components.</summary>
    public static double Rmse(Picture a, Picture b)
    {
        double sum = 0;
        for (int i = 0; i < a.Pixels.Length; i++)
        {
            Intensity difference = a.Pixels[i] - b.Pixels[i];
            sum += ((double)difference.R * difference.R) + ((double)difference.G * difference.G) + ((double)difference.B * difference.B);
        }

        return Math.Sqrt(sum / (3.0 * a.Pixels.Length));
    }
}
