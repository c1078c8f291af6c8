using System.Globalization;

namespace Exercises;

/// <summary>Checks of texel arithmetic: null if all is right, else the first fault in words.</summary>
public static class TexelChecks
{
    /// <summary>Exercise 4.</summary>
    /// <param name="repeat">Texel and size to texel.</param>
    public static string? Repeat(Func<int, int, int> repeat)
    {
        foreach ((int texel, int expected) in new[] { (0, 0), (3, 3), (4, 0), (9, 1), (-1, 3), (-4, 0), (-5, 3), (int.MaxValue, 3), (int.MinValue, 0) })
        {
            int got = repeat(texel, 4);
            if (got != expected)
            {
                return $"texel {texel} of a row of 4 should be {expected}, it is {got}.{(got == texel % 4 ? " C#'s % has the sign of its left side." : "")}";
            }
        }

        return null;
    }

    /// <summary>Exercise 5.</summary>
    /// <param name="sample">Texture, u and v to colour.</param>
    public static string? Bilinear(Func<Texture, double, double, Intensity> sample)
    {
        Intensity[,] colors = { { new(0, 0, 0), new(0, 1, 0) }, { new(1, 0, 0), new(1, 1, 0) }, { new(1, 0, 1), new(0, 0, 1) } };
        Texture texture = new(colors);
        Texture exact = texture.With(new SamplingOptions { Texels = TexelConvention.Lab, WrapU = TextureWrap.Clamp, WrapV = TextureWrap.Clamp });
        foreach ((double u, double v) in new[] { (0, 0), (0.5, 0), (0, 1), (0.25, 0), (0, 0.5), (0.25, 0.25), (0.6, 0.7), (1, 0.5), (0.5, 1), (1, 1) })
        {
            Intensity expected = exact.Sample(TextureLookup.At(u, v)), got = sample(texture, u, v), difference = expected - got;
            if (!(difference.Max <= 1e-5f && (difference * -1).Max <= 1e-5f))
            {
                return string.Create(
                    CultureInfo.InvariantCulture,
                    $"at ({u}, {v}) the colour should be ({expected.R}, {expected.G}, {expected.B}), it is ({got.R}, {got.G}, {got.B}).");
            }
        }

        return null;
    }
}
