using LabRaytracer;

namespace RenderScene;

/// <summary>Pictures that are data, not colours: heights, normals, occlusion. Their codes are the numbers times 255.</summary>
internal static class ReliefPictures
{
    /// <summary>Their file names and how they are drawn.</summary>
    public static IReadOnlyDictionary<string, Func<Picture>> All { get; } = new Dictionary<string, Func<Picture>>
    {
        ["bricks-height.png"] = () => TexturePictures.Draw(512, 256, (u, v) => Intensity.Grey(BrickHeight(u, v))),
        ["bricks-occlusion.png"] = () => TexturePictures.Draw(512, 256, (u, v) => Intensity.Grey(BrickOcclusion(u, v))),
        ["studs-normal.png"] = () => TexturePictures.Draw(256, 256, StudNormal),
    };

    /// <summary>Height of the wall of bricks.png: rounded bricks of rough clay, 0 to 1.</summary>
    private static float BrickHeight(float u, float v)
    {
        (float edge, int brick, int course) = Brick(u, v);
        float rise = Math.Clamp(edge / 0.05f, 0, 1);
        float grain = LatticeNoise.Fractal(u, v, 64, 32, 33);
        float stone = 0.75f + (0.1f * LatticeNoise.At(brick, course, 17)) + (0.15f * grain);
        return (rise * rise * (3 - (2 * rise)) * stone) + ((1 - rise) * 0.12f * grain);
    }

    /// <summary>How open the wall is to the sky: narrow joints are not.</summary>
    private static float BrickOcclusion(float u, float v) => 0.25f + (0.75f * Math.Clamp((Brick(u, v).Edge + 0.03f) / 0.09f, 0, 1));

    /// <summary>Distance from the joint, course heights; below 0 inside the joint.</summary>
    private static (float Edge, int Brick, int Course) Brick(float u, float v)
    {
        int course = (int)(v * 8);
        float along = (u * 8) + (course % 2 * 0.5f), up = (v * 8) - course, inside = along - MathF.Floor(along);
        float across = MathF.Min(inside, 1 - inside) * 2;
        return (MathF.Min(across - 0.06f, MathF.Min(up, 1 - up) - 0.06f), (int)along % 8, course);
    }

    /// <summary>Normals of 4 x 4 round studs, z out of the surface.</summary>
    private static Intensity StudNormal(float u, float v)
    {
        float x = ((u * 4) - MathF.Floor(u * 4) - 0.5f) * 2, y = ((v * 4) - MathF.Floor(v * 4) - 0.5f) * 2;
        float radius = MathF.Sqrt((x * x) + (y * y)), slope = 0;
        if (radius is > 0.4f and < 0.8f)
        {
            // A shoulder whose slope begins and ends with 0.
            float t = (radius - 0.4f) / 0.4f;
            slope = 6 * t * (1 - t);
        }

        float nx = radius > 0 ? slope * x / radius : 0, ny = radius > 0 ? slope * y / radius : 0;
        float length = MathF.Sqrt((nx * nx) + (ny * ny) + 1);
        return new Intensity((1 + (nx / length)) / 2, (1 + (ny / length)) / 2, (1 + (1 / length)) / 2);
    }
}
