namespace LabRaytracer.Tests;

public class MeshTests
{
    private static readonly Point3D[] s_square = [new(0, 0, 0), new(2, 0, 0), new(2, 2, 0), new(0, 2, 0)];
    private static readonly int[] s_corners = [0, 1, 2, 0, 2, 3];

    [Fact]
    public void Constructor_VertexNumberOutOfRange_NamesTriangleAndRange()
    {
        ArgumentException error = Assert.Throws<ArgumentException>(() => new TriangleMesh(s_square, [0, 1, 2, 0, 4, 3]));
        Assert.Contains("Corner 1 of triangle 1", error.Message);
        Assert.Contains("0 to 3", error.Message);
    }

    [Fact]
    public void Constructor_CoordinateNotFinite_NamesIt() =>
        Assert.Contains("positions at 1 is NaN", Assert.Throws<ArgumentException>(() => new TriangleMesh([0.0, 0, 0, 1, double.NaN, 0, 0, 1, 0], [0, 1, 2])).Message);

    [Fact]
    public void Render_Mesh_GeometryBytesHoldPositionsCornersAndTree()
    {
        TriangleMesh mesh = MeshSamples.BumpyBall(3, 5, out _, out _);
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0, 0, 5), Point3D.Origin, 40) };
        scene.Add(mesh, new Material());
        long bytes = Renderer.Render(scene, new RenderOptions { Width = 8, Height = 8 }).Statistics.GeometryBytes;

        // 3 floats or doubles a vertex, 3 numbers and 4 more of the tree's order a triangle, and boxes.
        Assert.InRange(bytes, (12 * mesh.VertexCount) + (28 * mesh.TriangleCount), (200 * mesh.TriangleCount) + 4096);
    }

    [Fact]
    public void Constructor_NoTriangles_Throws() => Assert.Throws<ArgumentException>(() => new TriangleMesh(s_square, []));

    [Fact]
    public void Constructor_NormalNumberOutOfRange_Throws() => Assert.Throws<ArgumentException>(
        () => new TriangleMesh(s_square, s_corners, new MeshOptions { Normals = new double[] { 0, 0, 1 } }));

    [Fact]
    public void Constructor_TriangleWithoutArea_RejectsOrDrops()
    {
        int[] corners = [0, 1, 1, 0, 1, 2, 0, 2, 0, 0, 2, 3];
        Assert.Contains("Triangle 0 has no area", Assert.Throws<ArgumentException>(() => new TriangleMesh(s_square, corners)).Message);
        TriangleMesh mesh = new(s_square, corners, new MeshOptions { DegenerateTriangles = DegenerateTriangles.Drop });
        Assert.Equal((4, 2), (mesh.TriangleCount, mesh.DegenerateCount));
        Assert.True(mesh.Intersect(new Ray(new Point3D(0.5, 1, 1), new Vector3D(0, 0, -1)), 5, out Hit hit));
        Assert.Equal((1.0, 3), (hit.T, hit.Part));
    }

    [Fact]
    public void Constructor_OnlyTrianglesWithoutArea_HitsNothing()
    {
        TriangleMesh mesh = new(s_square, [0, 1, 1], new MeshOptions { DegenerateTriangles = DegenerateTriangles.Drop });
        Assert.False(mesh.Intersect(new Ray(new Point3D(0.5, 0, 1), new Vector3D(0, 0, -1)), 5, out _));
        Assert.True(mesh.Bounds.IsEmpty);
    }

    [Theory]
    [InlineData(0.5, 0.25, 0)]
    [InlineData(0.25, 1.5, 1)]
    public void SurfaceAt_SquareWithCoordinates_InterpolatesThem(double x, double y, int part)
    {
        MeshOptions options = new() { TextureCoordinates = new double[] { 0, 0, 1, 0, 1, 1, 0, 1 } };
        TriangleMesh mesh = new(s_square, s_corners, options);
        Ray ray = new(new Point3D(x, y, 3), new Vector3D(0, 0, -2));
        Assert.True(mesh.Intersect(ray, 2, out Hit hit));
        Assert.Equal((1.5, part), (hit.T, hit.Part));
        SurfacePoint surface = mesh.SurfaceAt(ray, hit);
        Assert.Equal(new Point3D(x, y, 0), surface.Point);
        Assert.Equal(surface.Point, surface.Position.LocalPoint);
        Assert.Equal(new Vector3D(0, 0, 1), surface.Normal);
        Assert.Equal(surface.Normal, surface.ShadingNormal);
        Assert.Equal(new TextureCoordinate(x / 2, y / 2), surface.Position.Surface);
        Assert.Equal(surface.Position.Surface, mesh.DefaultMapping.Map(surface.Position));
    }

    [Fact]
    public void SurfaceAt_NormalsOnTheOtherSide_FlipTheGeometricOne()
    {
        MeshOptions options = new() { Normals = new double[] { 0, 0, -1, 0, 3, -4 }, NormalCorners = new[] { 0, 0, 0, 1, 1, 1 } };
        TriangleMesh mesh = new(s_square, s_corners, options);
        Ray ray = new(new Point3D(0.25, 1, 3), new Vector3D(0, 0, -1));
        Assert.True(mesh.Intersect(ray, 9, out Hit hit));
        SurfacePoint surface = mesh.SurfaceAt(ray, hit);
        Assert.Equal(new Vector3D(0, 0, -1), surface.Normal);
        Assert.Equal(0.6, surface.ShadingNormal.Y, 1e-15);
        Assert.Equal(-0.8, surface.ShadingNormal.Z, 1e-15);
    }

    [Fact]
    public void SurfaceAt_NormalsThatCancel_FallsBackOnTheGeometricOne()
    {
        MeshOptions options = new() { Normals = new double[] { 1, 0, 0, -1, 0, 0 }, NormalCorners = new[] { 0, 1, 0, 0, 0, 1 } };
        TriangleMesh mesh = new(s_square, s_corners, options);
        Ray ray = new(new Point3D(1, 0, 3), new Vector3D(0, 0, -1));
        SurfacePoint surface = mesh.SurfaceAt(ray, new Hit(3, 0, 0.5, 0));
        Assert.Equal(new Vector3D(0, 0, 1), surface.ShadingNormal);
    }

    [Fact]
    public void Surface_TwoMeshesInOnePacket_MatchesOneRayAtATime()
    {
        TriangleMesh ball = MeshSamples.BumpyBall(1, 21, out _, out _);
        TriangleMesh square = new(s_square, s_corners, new MeshOptions { TextureCoordinates = new double[] { 0, 0, 1, 0, 1, 1, 0, 1 } });
        Transform[] transforms = [Transform.Translation(new Vector3D(-2, 0, 0)), Transform.Scaling(new Vector3D(1, 0.5, 1))];
        MeshTwoMeshes.AssertSurfaces<Double8, Float8, Int8>([ball, square], transforms);
        MeshTwoMeshes.AssertSurfaces<Double1, Float1, Int1>([ball, square], transforms);
    }

    [Fact]
    public void Bytes_MeshWithAllAttributes_AtMostHundredATriangle()
    {
        const int Across = 100, Around = 50;
        MeshTorus torus = new(Across, Around);
        TriangleMesh mesh = torus.Mesh();
        mesh.Tree(1);
        Assert.Equal(2 * Across * Around, mesh.TriangleCount);
        Assert.InRange(mesh.Bytes / (double)mesh.TriangleCount, 1, 100);
    }
}
