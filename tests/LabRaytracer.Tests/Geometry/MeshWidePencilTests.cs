namespace LabRaytracer.Tests;

/// <summary>Pencils whose rays are far from each other for the size of the triangles are given up, and lose nothing by it.</summary>
public class MeshWidePencilTests
{
    private const int Side = 16;

    private static readonly Point3D s_eye = new(0.3, 4.5, 0.4);

    private static readonly TriangleMesh s_torus = new MeshTorus(200, 100).Mesh();

    [Fact]
    public void Nearest_OneRayForManyTriangles_TooWideButNotWhereRaysAreNear()
    {
        Assert.Equal(PencilAnswer.TooWide, Search<Double16, Float16, Int16>(Camera(1.4)));
        Assert.Equal(PencilAnswer.TooWide, Search<Float8, Float8, Int8>(Camera(1.4)));
        Assert.Equal(PencilAnswer.Found, Search<Double16, Float16, Int16>(Camera(0.02)));
        Assert.Equal(PencilAnswer.Found, Search<Float8, Float8, Int8>(Camera(0.02)));
    }

    [Fact]
    public void Nearest_PencilGivenUp_SameBitsAsEveryTriangle()
    {
        Ray[] rays = Camera(1.4);
        Assert.InRange(MeshAssert.Nearest(s_torus, rays).Count(hit => hit.T > 0), 100, rays.Length);
    }

    [Fact]
    public void Block_PencilGivenUp_SameAsEveryTriangle()
    {
        // To a lamp from all over a plane below, as if mirrors had sent them there.
        Point3D lamp = new(0.1, 4, 0.2);
        Random random = new(12);
        Point3D[] origins = [.. Enumerable.Range(0, Side * Side).Select(_ => new Point3D((3 * random.NextDouble()) - 1.5, -1, (3 * random.NextDouble()) - 1.5))];
        Ray[] rays = [.. origins.Select(origin => new Ray(origin, (lamp - origin).Normalized()))];
        double[] limits = [.. origins.Select(origin => (lamp - origin).Length)];
        bool[] blocked = MeshAssert.Blocked(s_torus, rays, limits, null);
        Assert.Contains(true, blocked);
        Assert.Contains(false, blocked);
    }

    /// <summary>Rays to a grid of points around the middle of the torus, or of its tube.</summary>
    private static Ray[] Camera(double reach) =>
        [.. Enumerable.Range(0, Side * Side).Select(i => new Ray(
            s_eye, (new Point3D((reach * ((i % Side / 7.5) - 1)) + (reach < 1 ? 1 : 0), 0, reach * ((i / Side / 7.5) - 1)) - s_eye).Normalized()))];

    private static unsafe PencilAnswer Search<R, F, I>(Ray[] rays)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        using MeshHits<R, F, I> run = new(rays);
        using LaneMemory memory = new();
        int count = Math.Min(run.Rays.Packets, MeshPencil.MostPackets);
        PencilLanes<R, F, I>* lanes = (PencilLanes<R, F, I>*)memory.Column<PencilLanes<R, F, I>>(count, 1);
        for (int packet = 0; packet < count; packet++)
        {
            lanes[packet].Ray = run.Rays.Load(packet);
            lanes[packet].Limit = run.Hits.T[packet];
        }

        return MeshPencil.Nearest(s_torus.Data, s_torus.Tree(1), lanes, count, run.Hits, 0, 0);
    }
}
