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
            PlaneKernel.Smooth(shape, ray, ref found, to.Columns, 0, SurfaceNeeds.LocalPoint);
            surface = [to.PointX->Value, to.PointY->Value, to.PointZ->Value, to.Slack->Value, to.Positions.X->Value, to.Positions.Y->Value, to.Positions.Z->Value];
        }

        return isHit;
    }
}
