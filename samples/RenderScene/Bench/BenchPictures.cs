using LabRaytracer;

namespace RenderScene;

/// <summary>Pictures to measure with: busy ones that no cache likes, and checkers with edges as sharp as a texel.</summary>
internal static class BenchPictures
{
    /// <summary>A busy picture: noise of three sizes, stripes, and a random share in every texel.</summary>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="number">Which of the pictures: hue and stripes differ.</param>
    public static Picture Busy(int width, int height, int number)
    {
        Picture picture = new(width, height);
        Span<float> channels = stackalloc float[3];
        for (int y = 0; y < height; y++)
        {
            Span<Intensity> row = picture.Row(y);
            for (int x = 0; x < width; x++)
            {
                float stripe = (((x * (2 + (number % 3))) + (y * (1 + (number % 5)))) / 32 % 2 == 0) ? 0.12f : 0;
                for (int channel = 0; channel < 3; channel++)
                {
                    uint seed = (uint)((number * 16) + channel + 1);
                    float clouds = Math.Clamp((2.2f * Octaves((float)x / width, (float)y / height, seed)) - 0.6f, 0, 1);
                    float grain = LatticeNoise.At(x, y, seed + 8);
                    channels[channel] = (0.68f * clouds) + stripe + (0.2f * grain);
                }

                row[x] = new Intensity(channels[0], channels[1], channels[2]);
            }
        }

        return picture;
    }

    /// <summary>A checkerboard, black at the top left corner of the file.</summary>
    /// <param name="side">Columns and rows; a multiple of the squares.</param>
    /// <param name="squares">Squares along a side.</param>
    public static Picture Checker(int side, int squares)
    {
        Picture picture = new(side, side);
        int square = side / squares;
        for (int y = 0; y < side; y++)
        {
            Span<Intensity> row = picture.Row(y);
            for (int x = 0; x < side; x++)
            {
                row[x] = ((x / square) + (y / square)) % 2 == 0 ? Intensity.Black : Intensity.White;
            }
        }

        return picture;
    }

    private static float Octaves(float u, float v, uint seed) =>
        (0.55f * LatticeNoise.Smooth(u, v, 6, 3, seed))
        + (0.3f * LatticeNoise.Smooth(u, v, 32, 16, seed + 3))
        + (0.15f * LatticeNoise.Smooth(u, v, 160, 80, seed + 5));
}
