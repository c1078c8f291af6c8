namespace LabRaytracer.Tests.Rendering;

/// <summary>Orientation of the background: which texel is seen in which direction (docs/surroundings.md has the table).</summary>
public sealed class BackgroundTests
{
    [Theory]
    [InlineData(64, 32, 0)]
    [InlineData(7, 3, 0)]
    [InlineData(255, 127, 0)]
    [InlineData(64, 32, 90)]
    [InlineData(64, 32, -180)]
    public void SphericalCamera_SeesThePictureBack(int width, int height, double degrees)
    {
        // A turn of the background by a quarter moves the picture by a quarter of its columns.
        Texture texture = TestScenes.Random(width, height).With(new SamplingOptions { Filter = TextureFilter.Nearest });
        var scene = new Scene { Camera = new SphericalCamera(new Point3D(3, -2, 8)), Background = texture, BackgroundRotation = Transform.Rotation(Vector3D.UnitY, degrees) };
        Picture seen = TestScenes.Render(scene, width, height);
        int moved = (int)Math.Round(degrees / 360 * width);
        int differing = 0;
        for (int x = 0; x < width; x++)
        {
            for (int y = 0; y < height; y++)
            {
                differing += texture.ColorMap[x, y] == seen[(x + moved + width) % width, height - 1 - y] ? 0 : 1;
            }
        }

        Assert.Equal(0, differing);
    }

    [Theory]
    [InlineData(0, 0, 1, 0, 0.5)]
    [InlineData(1, 0, 0, 0.25, 0.5)]
    [InlineData(0, 0, -1, 0.5, 0.5)]
    [InlineData(-1, 0, 0, 0.75, 0.5)]
    [InlineData(1, 0, 1, 0.125, 0.5)]
    [InlineData(0, 1, 1, 0, 0.75)]
    [InlineData(0, -1, -1, 0.5, 0.25)]
    public void CameraLookingAlongADirection_SeesTheColumnOfTheTable(double x, double y, double z, double u, double v)
    {
        Intensity seen = Look(new Vector3D(x, y, z), Transform.Identity);
        Assert.Equal(u, seen.R, 1e-6);
        Assert.Equal(v, seen.G, 1e-6);
    }

    [Fact]
    public void Rotation_MovesAPlaceOfThePictureToWhereTheTransformMovesItsDirection()
    {
        Transform rotation = Transform.Rotation(new Vector3D(1, 2, 3), 77);
        Vector3D direction = new(0.4, -0.7, 0.2);
        Intensity still = Look(direction, Transform.Identity), turned = Look(rotation.WorldFromObject(direction), rotation);
        Assert.Equal(still.R, turned.R, 1e-6);
        Assert.Equal(still.G, turned.G, 1e-6);
    }

    [Theory]
    [InlineData(32)]
    [InlineData(101)]
    public void FisheyeOfAllDirections_SeesALightProbeBack(int size)
    {
        // Inside of the circle; outside of it a light probe has no directions.
        Texture texture = TestScenes.Random(size, size).With(new SamplingOptions { Filter = TextureFilter.Nearest });
        var scene = new Scene
        {
            Camera = new FisheyeCamera(new Point3D(1, 2, 3), new Point3D(1, 2, 2), 360),
            Background = new TextureSlot { Texture = texture, Mapping = new LightProbeMapping { Facing = LightProbeFacing.NegativeZ } },
        };
        Picture seen = TestScenes.Render(scene, size, size);
        int inside = 0, differing = 0;
        for (int i = 0; i < size * size; i++)
        {
            int x = i % size, y = i / size;
            double a = (2 * (x + 0.5) / size) - 1, b = (2 * (y + 0.5) / size) - 1;
            if ((a * a) + (b * b) < 1)
            {
                inside++;
                differing += texture.ColorMap[x, y] == seen[x, size - 1 - y] ? 0 : 1;
            }
        }

        Assert.True(inside > 0.75 * size * size);
        Assert.Equal(0, differing);
    }

    [Fact]
    public void Mirror_ShowsWhatLiesInTheMirroredDirection()
    {
        var scene = new Scene
        {
            Camera = new OrthographicCamera(new Point3D(0, 1, 1), Point3D.Origin, 1e-6),
            Background = TextureSlot.Of(new Coordinates()),
        };
        scene.Add(new InfinitePlane(), new Material { Diffuse = Intensity.Black, Reflection = Intensity.White });
        Intensity seen = TestScenes.Render(scene, 1, 1)[0, 0];
        Assert.Equal(0.5, seen.R, 1e-6);
        Assert.Equal(0.75, seen.G, 1e-6);
    }

    [Fact]
    public void Intensity_IsTheSlotsValue()
    {
        var scene = new Scene { Background = new TextureSlot { Texture = new Texture(new[,] { { Intensity.White } }), Value = new Intensity(3, 4, 5) } };
        Assert.Equal(new Intensity(3, 4, 5), TestScenes.Render(scene, 1, 1)[0, 0]);
    }

    [Fact]
    public void BackgroundRotation_NotARotation_IsRefused()
    {
        var scene = new Scene();
        ArgumentException failure = Assert.Throws<ArgumentException>(() => scene.BackgroundRotation = Transform.Scaling(new Vector3D(2, 2, 2)));
        Assert.Contains("can only be rotated", failure.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentNullException>(() => scene.BackgroundRotation = null!);
    }

    private static Intensity Look(Vector3D direction, Transform rotation)
    {
        var scene = new Scene
        {
            Camera = new OrthographicCamera(Point3D.Origin, Point3D.Origin + direction, 1, new Vector3D(0.1, 1, 0.2)),
            Background = TextureSlot.Of(new Coordinates()),
            BackgroundRotation = rotation,
        };
        return TestScenes.Render(scene, 1, 1)[0, 0];
    }

    /// <summary>u in red, v in green.</summary>
    private sealed class Coordinates : ITexture
    {
        public Intensity Sample(in TextureLookup lookup) => new((float)lookup.Coordinate.U, (float)lookup.Coordinate.V, 0);
    }
}
