using LabRaytracer;

namespace RenderScene;

/// <summary>A lat-long picture of an evening landscape, to be used as a background that mirrors show.</summary>
internal static class SkyPicture
{
    /// <summary>Where the sun stands.</summary>
    private const float SunU = 0.62f, SunV = 0.585f;

    /// <summary>Radius of the bright sun, as a part of the height of the picture: 1.1 degrees.</summary>
    private const float SunRadius = 0.006f;

    /// <summary>The colour in a direction: u around, v from the nadir to the zenith.</summary>
    public static Intensity ColorAt(float u, float v)
    {
        float ridge = 0.5f + (0.075f * (LatticeNoise.Fractal(u, 0.5f, 8, 1, 71) - 0.35f));
        float hills = 0.49f + (0.05f * (LatticeNoise.Fractal(u, 0.5f, 16, 1, 83) - 0.4f));
        Intensity mountains = Intensity.Lerp(new Intensity(0.1f, 0.13f, 0.22f), new Intensity(0.3f, 0.26f, 0.3f), (v - 0.47f) * 8);
        Intensity far = Intensity.Lerp(Sky(u, v), mountains, Below(v, ridge));
        return Intensity.Lerp(far, Ground(u, v, hills), Below(v, hills));
    }

    /// <summary>The same with the sun as bright as it has to be to light the landscape: for a picture of floats.</summary>
    public static Intensity RadianceAt(float u, float v)
    {
        float du = (u - SunU) * 2, dv = v - SunV;
        return ColorAt(u, v) + ((du * du) + (dv * dv) < SunRadius * SunRadius ? new Intensity(5200, 3900, 2500) : Intensity.Black);
    }

    /// <summary>1 below a height, 0 above it, over three texels in between: an edge that shows no steps when it is magnified.</summary>
    private static float Below(float v, float height) => Math.Clamp(((height - v) * 340) + 0.5f, 0, 1);

    private static Intensity Ground(float u, float v, float top)
    {
        float field = LatticeNoise.Smooth(u, v, 24, 40, 91), depth = Math.Clamp((top - v) * 3, 0, 1);
        Intensity near = Intensity.Lerp(new Intensity(0.07f, 0.1f, 0.035f), new Intensity(0.16f, 0.17f, 0.06f), field);
        return Intensity.Lerp(new Intensity(0.1f, 0.13f, 0.08f), near, depth);
    }

    private static Intensity Sky(float u, float v)
    {
        float height = Math.Clamp((v - 0.5f) * 2, 0, 1);
        Intensity low = new(0.95f, 0.62f, 0.36f), middle = new(0.42f, 0.55f, 0.75f), high = new(0.07f, 0.16f, 0.42f);
        Intensity clear = height < 0.3f ? Intensity.Lerp(low, middle, height / 0.3f) : Intensity.Lerp(middle, high, (height - 0.3f) / 0.7f);
        float cloud = Math.Clamp((LatticeNoise.Fractal(u, v, 10, 24, 55) - 0.53f) * 6, 0, 1) * Math.Clamp(height * 6, 0, 1) * Math.Clamp((0.8f - height) * 3, 0, 1);
        Intensity clouded = Intensity.Lerp(clear, new Intensity(0.95f, 0.86f, 0.8f), 0.75f * cloud);
        float du = (u - SunU) * 2, dv = v - SunV, distance = (du * du) + (dv * dv);
        float glow = 0.0006f / (distance + 0.0006f);
        return clouded + (new Intensity(1, 0.8f, 0.5f) * (distance < 0.0004f ? 2 : glow));
    }
}
