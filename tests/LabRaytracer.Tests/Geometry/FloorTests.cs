namespace LabRaytracer.Tests.Geometry;

/// <summary>The plane y = c has formulas of its own: their numbers are those of any plane.</summary>
public unsafe class FloorTests
{
    private const int Floor = 12;

    [Theory]
    [InlineData(-1.0)]
    [InlineData(0.1)]
    [InlineData(1e6)]
    public void Intersect_Floor_HasTheBitsOfAnyPlane(double height)
    {
        double* numbers = stackalloc double[PlaneKernel.ParameterCount];
        PlaneKernel.Describe(new InfinitePlane(new Point3D(0.3, height, -7), Vector3D.UnitY), Transform.Identity, new Span<double>(numbers, PlaneKernel.ParameterCount));
        Assert.Equal(1, numbers[Floor]);
        Random random = new(7);
        int hits = 0;
        for (int k = 0; k < 20000; k++)
        {
            RayLanes<Double1> ray = RandomRay(random, height);
            numbers[Floor] = 1;
            bool isHit = Look(numbers, ray, out double t, out double[] surface);
            numbers[Floor] = 0;
            Assert.Equal(Look(numbers, ray, out double anyT, out double[] anySurface), isHit);
            if (isHit)
            {
                hits++;
                Assert.Equal(BitConverter.DoubleToInt64Bits(anyT), BitConverter.DoubleToInt64Bits(t));
                Assert.Equal(anySurface, surface);
            }
        }

        Assert.InRange(hits, 5000, 15000);
    }

    [Fact]
    public void Surface_BatchOfFloor_SameBitsAsOneRay() => new BatchTest().RunAllDoubles();

    /// <summary>Near and far, steep and grazing.</summary>
    private static RayLanes<Double1> RandomRay(Random random, double height)
    {
        double Any(double size) => size * ((2 * random.NextDouble()) - 1);
        double away = Math.Pow(10, Any(8)), slope = Math.Pow(10, -8 * random.NextDouble());
        Vector3D direction = new Vector3D(Any(1), Any(1) * slope, Any(1)).Normalized();
        return new RayLanes<Double1>(
            new(Any(10)), new(height + Any(away)), new(Any(1000)), new(direction.X), new(direction.Y), new(direction.Z));
    }

    private static bool Look(double* numbers, in RayLanes<Double1> ray, out double t, out double[] surface)
    {
        SharedParameters<Double1, Float1, Int1> shape = new((Double1*)numbers, 0);
        bool isHit = Double1.Any(PlaneKernel.Intersect(shape, ray, out Double1 found));
        t = found.Value;
        surface = [];
        if (isHit)
        {
            using LaneMemory memory = new();
            SurfaceBatch<Double1, Float1, Int1> to = new(memory, 1);
            PlaneKernel.Smooth(shape, ray, found, to.Columns, 0, SurfaceNeeds.LocalPoint);
            surface = [to.PointX->Value, to.PointY->Value, to.PointZ->Value, to.Slack->Value, to.Positions.X->Value, to.Positions.Y->Value, to.Positions.Z->Value];
        }

        return isHit;
    }

    /// <summary>Runs of consecutive rays, and rays that hit here and there.</summary>
    private sealed class BatchTest : ILaneTest
    {
        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            InfinitePlane floor = new(new Point3D(0.3, -1, -7), Vector3D.UnitY);
            Random random = new(5);
            Ray[] rays = [.. Enumerable.Range(0, 300).Select(i => new Ray(
                new Point3D(random.NextDouble(), 2, 9 * random.NextDouble()),
                new Vector3D(random.NextDouble() - 0.5, i < 100 ? -1 : random.NextDouble() - 0.5, random.NextDouble()).Normalized()))];
            using ShapeRun<R, F, I> run = new([floor], Transform.Identity, rays.Length);
            run.SetRays(rays);
            run.Nearest();
            int[] hits = run.Surface();
            Assert.InRange(hits.Length, 150, 250);
            for (int i = 0; i < hits.Length; i++)
            {
                Assert.True(floor.Intersect(rays[hits[i]], double.PositiveInfinity, out Hit hit));
                Assert.Equal(ShapeRun<R, F, I>.Numbers(floor.SurfaceAt(rays[hits[i]], hit)), run.SurfaceNumbers(i));
            }
        }
    }
}
