using LabRaytracer.Tests.Geometry;

namespace LabRaytracer.Tests.Cameras;

/// <summary>Ray directions against 50-digit arithmetic (Oracle/geometry_cameras.py), and the wide path against the single one.</summary>
public sealed class CameraTests
{
    private static readonly PerspectiveCamera s_perspective = new(new Point3D(1, 2, 3), new Point3D(-2, 0.5, -4), 50);

    [Theory]
    [InlineData(0.5, 0.5, -0.784173085121917546, 0.208047686352109455, -0.584627003117293709)]
    [InlineData(319.5, 239.5, -0.387460488168181942, -0.192293644305143591, -0.90160829880182506)]
    [InlineData(320, 240, -0.386493975840498516, -0.193246987920249258, -0.901819276961163204)]
    [InlineData(639.5, 100.5, 0.135329229427175572, 0.0601790349416288832, -0.98897142699682739)]
    [InlineData(17.25, 479.75, -0.713245806985532043, -0.520147057992632088, -0.469816407630860208)]
    public void RayAt_Perspective_MatchesOracle(double x, double y, double dx, double dy, double dz)
    {
        Ray ray = s_perspective.RayAt(x, y, 640, 480);
        Assert.Equal(new Point3D(1, 2, 3), ray.Origin);
        Assert.Equal(0, (ray.Direction - new Vector3D(dx, dy, dz)).Length, 4e-16);
    }

    [Theory]
    [InlineData(0.5, 0.5, 9.4123586994286715e-6, 0.999995293809576172, 0.00306794232457723768)]
    [InlineData(511.5, 255.5, 0.00306794232457723768, 0.00306795676296597627, -0.999990587641300571)]
    [InlineData(768, 256, -1.0, 0, 0)]
    [InlineData(1023.5, 511.5, -9.4123586994286715e-6, -0.999995293809576172, 0.00306794232457723768)]
    [InlineData(100.5, 300.5, 0.55688915953272625, -0.269668325572915107, 0.785591152048973902)]
    public void RayAt_Spherical_MatchesOracle(double x, double y, double dx, double dy, double dz)
    {
        Ray ray = new SphericalCamera(new Point3D(4, 5, 6)).RayAt(x, y, 1024, 512);
        Assert.Equal(new Point3D(4, 5, 6), ray.Origin);
        Assert.Equal(0, (ray.Direction - new Vector3D(dx, dy, dz)).Length, 4e-16);
    }

    [Fact]
    public void RayAt_SphericalOverTheWholePicture_MappingGivesThePositionBack()
    {
        SphericalCamera camera = new(Point3D.Origin);
        SphericalMapping mapping = new();
        Sphere sphere = new(Point3D.Origin, 7);
        for (int y = 0; y < 64; y++)
        {
            for (int x = 0; x < 128; x++)
            {
                Ray ray = camera.RayAt(x + 0.5, y + 0.5, 128, 64);
                Assert.True(sphere.Intersect(ray, double.PositiveInfinity, out Hit hit));
                TextureCoordinate uv = mapping.Map(sphere.SurfaceAt(ray, hit).Position);
                Assert.Equal((x + 0.5) / 128, uv.U, 1e-15);
                Assert.Equal(1 - ((y + 0.5) / 64), uv.V, 1e-15);
            }
        }
    }

    [Fact]
    public void RayAt_OrthographicCorners_SpanTheHeightInSceneUnits()
    {
        // From above, the picture's up being -z: right is +x. 6 units high and 12 wide.
        OrthographicCamera camera = new(new Point3D(1, 9, 2), new Point3D(1, 0, 2), 6, -Vector3D.UnitZ);
        Assert.Equal(0, (camera.RayAt(0, 0, 200, 100).Origin - new Point3D(-5, 9, -1)).Length, 1e-15);
        Assert.Equal(0, (camera.RayAt(200, 100, 200, 100).Origin - new Point3D(7, 9, 5)).Length, 1e-15);
        Assert.Equal(new Ray(new Point3D(1, 9, 2), -Vector3D.UnitY), camera.RayAt(100, 50, 200, 100));
    }

    [Fact]
    public void Rays_AnyWidth_SameBitsAsOneRay() => new WideTest().RunAllDoubles();

    [Fact]
    public void Constructor_BadArguments_SaysWhatIsAllowed()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new PerspectiveCamera(Point3D.Origin, Point3D.Origin, 40));
        Assert.Throws<ArgumentOutOfRangeException>(() => new PerspectiveCamera(Point3D.Origin, new Point3D(0, 0, 1), 180));
        Assert.Throws<ArgumentOutOfRangeException>(() => new PerspectiveCamera(Point3D.Origin, new Point3D(0, 1, 0), 40));
        Assert.Throws<ArgumentOutOfRangeException>(() => new OrthographicCamera(Point3D.Origin, new Point3D(0, 0, 1), 0));
        Assert.Throws<ArgumentOutOfRangeException>(() => new SphericalCamera(new Point3D(0, double.NaN, 0)));
    }

    private sealed unsafe class WideTest : ILaneTest
    {
        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            Camera[] cameras = [s_perspective, new OrthographicCamera(new Point3D(1, 2, 3), Point3D.Origin, 2.5), new SphericalCamera(new Point3D(1, 2, 3))];
            using LaneMemory memory = new();
            R* x = memory.Column<R>(48, R.Width);
            R* y = memory.Column<R>(48, R.Width);
            RayBatch<R, F, I> rays = new(memory, 48);
            RayColumns<R> columns = new()
            {
                OriginX = rays.OriginX, OriginY = rays.OriginY, OriginZ = rays.OriginZ,
                DirectionX = rays.DirectionX, DirectionY = rays.DirectionY, DirectionZ = rays.DirectionZ,
            };
            foreach (Camera camera in cameras)
            {
                for (int i = 0; i < 48; i++)
                {
                    R.Put(x, i, i * 1.37);
                    R.Put(y, i, 47.5 - (i * 0.91));
                }

                ((IWideCamera)camera).Rays(x, y, columns, 48 / R.Width, 70, 50);
                for (int i = 0; i < 48; i++)
                {
                    Assert.Equal(camera.RayAt(i * 1.37, 47.5 - (i * 0.91), 70, 50), rays[i]);
                }
            }
        }
    }
}
