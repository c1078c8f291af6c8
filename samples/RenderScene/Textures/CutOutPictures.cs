using LabRaytracer;

namespace RenderScene;

/// <summary>Pictures with alpha: parts of them are not there.</summary>
internal static class CutOutPictures
{
    private const int Side = 128, Points = 3;

    /// <summary>Their file names and how they are drawn.</summary>
    public static IReadOnlyDictionary<string, Func<byte[]>> All { get; } = new Dictionary<string, Func<byte[]>>
    {
        ["leaf.png"] = () => RgbaPng.Encode(Side, Side, (x, y) => Mean(x, y, Leaf)),
        ["badge.png"] = () => RgbaPng.Encode(Side, Side, (x, y) => Mean(x, y, Badge)),
    };

    /// <summary>Mean of 3 x 3 points; colours weighted by alpha. Texels without any are black: filters must not let them tint the edge.</summary>
    private static (Intensity Color, float Alpha) Mean(int x, int y, Func<float, float, (Intensity Color, float Alpha)> draw)
    {
        Intensity sum = Intensity.Black;
        float alpha = 0;
        for (int point = 0; point < Points * Points; point++)
        {
            float u = (x + ((point % Points) + 0.5f) / Points) / Side, v = 1 - ((y + ((point / Points) + 0.5f) / Points) / Side);
            (Intensity color, float share) = draw(u, v);
            sum += color * share;
            alpha += share;
        }

        return (alpha > 0 ? sum * (1 / alpha) : Intensity.Black, alpha / (Points * Points));
    }

    /// <summary>An upright leaf with a stalk and veins.</summary>
    private static (Intensity Color, float Alpha) Leaf(float u, float v)
    {
        float x = (u - 0.5f) * 2, along = (v - 0.16f) / 0.8f;
        float half = along is > 0 and < 1 ? 0.95f * along * MathF.Sqrt(1 - along) * (1.9f - along) : 0;
        bool isStalk = MathF.Abs(x) < 0.03f && v is > 0.02f and < 0.9f;
        bool isLeaf = MathF.Abs(x) < half * (0.96f + (0.04f * MathF.Cos(60 * along)));
        float rib = (along * 9) - (MathF.Abs(x) * 5);
        bool isVein = MathF.Abs(x) < 0.015f || rib - MathF.Floor(rib) < 0.12f;
        float tone = 0.7f + (0.6f * LatticeNoise.Fractal(u, v, 8, 8, 7));
        Intensity green = new Intensity(0.1f, 0.32f, 0.05f) * tone;
        return (isStalk ? new Intensity(0.18f, 0.2f, 0.06f) : isVein ? new Intensity(0.25f, 0.42f, 0.12f) : green, isStalk || isLeaf ? 1 : 0);
    }

    /// <summary>A round badge with a star.</summary>
    private static (Intensity Color, float Alpha) Badge(float u, float v)
    {
        float x = (u - 0.5f) * 2, y = (v - 0.5f) * 2, radius = MathF.Sqrt((x * x) + (y * y));
        float turn = MathF.Atan2(x, y) * 5 / MathF.Tau;
        turn = MathF.Abs(turn - MathF.Round(turn)) * MathF.Tau / 5;

        // One point of the star: a line from its tip to the inner corner.
        float along = radius * MathF.Cos(turn), across = radius * MathF.Sin(turn);
        bool isStar = across < (0.72f - along) * 0.36f;
        bool isRing = radius is > 0.82f and < 0.9f;
        Intensity color = isStar || isRing ? new Intensity(0.95f, 0.8f, 0.15f) : new Intensity(0.55f, 0.03f, 0.04f);
        return (color, radius < 0.97f ? 1 : 0);
    }
}
