using LabRaytracer;

namespace RenderScene;

/// <summary>The small pictures of scenes/textures that are drawn by this program.</summary>
internal static class TexturePictures
{
    /// <summary>Their file names and how they are drawn.</summary>
    public static IReadOnlyDictionary<string, Func<Picture>> All { get; } = new Dictionary<string, Func<Picture>>
    {
        ["test-8x4.png"] = Test,
        ["wood.png"] = () => Draw(512, 512, Wood),
        ["crate.png"] = () => Draw(256, 256, Crate),
        ["bricks.png"] = () => Draw(512, 256, Bricks),
        ["spots.png"] = () => Draw(512, 256, Spots),
        ["sky.png"] = () => Draw(2048, 1024, SkyPicture.ColorAt),
        ["evening.hdr"] = () => Draw(512, 256, SkyPicture.RadianceAt),
        ["probe.png"] = Probe,
    };

    /// <summary>Draws a picture of a colour function of (u, v), v up: the mean of 3 x 3 points in each texel.</summary>
    public static Picture Draw(int width, int height, Func<float, float, Intensity> color)
    {
        Picture picture = new(width, height);
        Parallel.For(0, height, y =>
        {
            Span<Intensity> row = picture.Row(y);
            for (int x = 0; x < width; x++)
            {
                for (int point = 0; point < 9; point++)
                {
                    float u = (x + ((point % 3) + 0.5f) / 3) / width, v = 1 - ((y + ((point / 3) + 0.5f) / 3) / height);
                    row[x] += color(u, v) * (1 / 9f);
                }
            }
        });
        return picture;
    }

    /// <summary>8 x 4 texels, all different: hue by column, lighter towards the top, the bottom left texel white, the top right one black.</summary>
    private static Picture Test()
    {
        ReadOnlySpan<Intensity> hues =
        [
            new(0.8f, 0.05f, 0.05f), new(0.8f, 0.3f, 0.02f), new(0.75f, 0.65f, 0.02f), new(0.15f, 0.6f, 0.04f),
            new(0.02f, 0.5f, 0.45f), new(0.03f, 0.2f, 0.75f), new(0.25f, 0.06f, 0.7f), new(0.7f, 0.05f, 0.45f),
        ];
        Picture picture = new(8, 4);
        for (int y = 0; y < 4; y++)
        {
            for (int x = 0; x < 8; x++)
            {
                picture[x, y] = Intensity.Lerp(hues[x], y < 2 ? Intensity.White : Intensity.Black, y is 0 or 3 ? 0.5f : 0.12f);
            }
        }

        picture[0, 3] = Intensity.White;
        picture[7, 0] = Intensity.Black;
        return picture;
    }

    /// <summary>Four planks along v, their ends at different places.</summary>
    private static Intensity Wood(float u, float v)
    {
        int plank = (int)(u * 4);
        float across = (u * 4) - plank, along = v + (plank * 0.37f), end = along - MathF.Floor(along);
        float grain = LatticeNoise.Fractal(u, v, 32, 2, 11 + (uint)plank);
        float rings = (u * 12) + (5 * LatticeNoise.Smooth(u, v, 8, 2, 3));
        rings = MathF.Abs(rings - MathF.Floor(rings) - 0.5f) * 2;
        float tone = 0.5f + (0.25f * grain) + (0.15f * rings) + (0.16f * (LatticeNoise.At(plank, 0, 5) - 0.5f));
        bool isGap = across is < 0.012f or > 0.988f || end < 0.004f;
        return new Intensity(0.62f, 0.34f, 0.15f) * (isGap ? 0.12f : tone);
    }

    /// <summary>Boards inside a frame, with nails.</summary>
    private static Intensity Crate(float u, float v)
    {
        bool isFrame = u is < 0.12f or > 0.88f || v is < 0.12f or > 0.88f;
        bool isUpright = u is < 0.12f or > 0.88f;
        float board = isFrame ? (isUpright ? 7 : 8) : (int)(u * 5);
        float grain = isUpright || !isFrame ? LatticeNoise.Fractal(u, v, 24, 2, 40 + (uint)board) : LatticeNoise.Fractal(v, u, 24, 2, 60);
        float tone = (isFrame ? 0.62f : 0.42f) + (0.35f * grain);
        float gap = (u * 5) - MathF.Floor(u * 5);
        bool isShade = !isFrame && (gap is < 0.05f or > 0.95f || u is < 0.14f or > 0.86f || v is < 0.14f or > 0.86f);
        float nailU = MathF.Abs(MathF.Abs(u - 0.5f) - 0.44f), nailV = MathF.Abs(MathF.Abs(v - 0.5f) - 0.44f);
        bool isNail = (nailU * nailU) + (nailV * nailV) < 0.0004f;
        return isNail ? Intensity.Grey(0.12f) : new Intensity(0.66f, 0.42f, 0.2f) * (isShade ? 0.3f : tone);
    }

    /// <summary>Eight courses of bricks, every second one moved by half a brick.</summary>
    private static Intensity Bricks(float u, float v)
    {
        int course = (int)(v * 8);
        float along = (u * 8) + (course % 2 * 0.5f), up = (v * 8) - course;
        int brick = (int)along % 8;
        float inside = along - MathF.Floor(along);
        float grain = LatticeNoise.Fractal(u, v, 32, 16, 21);
        bool isMortar = inside is < 0.03f or > 0.97f || up is < 0.06f or > 0.94f;
        float tone = 0.65f + (0.5f * (LatticeNoise.At(brick, course, 9) - 0.5f)) + (0.4f * (grain - 0.5f));
        return isMortar ? Intensity.Grey(0.36f + (0.2f * grain)) : new Intensity(0.55f, 0.2f, 0.12f) * tone;
    }

    /// <summary>The landscape as a light probe that faces -Z: what a fisheye of 360 degrees sees of it.</summary>
    private static Picture Probe()
    {
        TextureSlot sky = new()
        {
            Texture = Texture.FromPicture(Draw(1024, 512, SkyPicture.ColorAt)),
            Transform = new UvTransform(new TextureCoordinate(0, 0), 0, new TextureCoordinate(-1, 1), new TextureCoordinate(0, 0)),
        };
        var scene = new Scene { Camera = new FisheyeCamera(Point3D.Origin, new Point3D(0, 0, -1), 360), Background = sky };
        return Renderer.Render(scene, new RenderOptions { Width = 512, Height = 512, Samples = 9 }).Picture;
    }

    /// <summary>Round spots in white on black: for slots that are switched on and off over a surface.</summary>
    private static Intensity Spots(float u, float v)
    {
        float x = (u * 24) - MathF.Floor(u * 24) - 0.5f, y = (v * 12) - MathF.Floor(v * 12) - 0.5f;
        float edge = ((x * x) + (y * y) - 0.105f) / 0.02f;
        return Intensity.Grey(Math.Clamp(0.5f - edge, 0, 1));
    }
}
