namespace LabRaytracer.Tests.Rendering;

/// <summary>Secondary rays come in the order of the rays that they come from, however hits were grouped.</summary>
public sealed class SecondaryOrderTests
{
    [Fact]
    public void LineUp_RaysInAnyOrder_ReflectedBeforeRefractedRayByRay()
    {
        SecondaryQueue queue = new(hasDifferentials: false);
        SecondaryRays rays = new(16);
        rays.Start(queue);
        Write(queue, rays.Reflect(9), 90, hasDifferentials: false);
        Write(queue, rays.Refract(2), 21, hasDifferentials: false);
        Write(queue, rays.Reflect(5), 50, hasDifferentials: false);
        Write(queue, rays.Reflect(2), 20, hasDifferentials: false);
        rays.LineUp(16);
        Assert.Equal([20, 21, 50, 90], Pixels(queue));

        // The next batch goes behind, and the first one is not given twice.
        Write(queue, rays.Reflect(0), 1, hasDifferentials: false);
        rays.LineUp(16);
        Assert.Equal([20, 21, 50, 90, 1], Pixels(queue));
        queue.Clear();
        Assert.Equal(0, queue.Count);
    }

    [Fact]
    public void LineUp_Layers_NearestFirst()
    {
        SecondaryQueue queue = new(hasDifferentials: true);
        SecondaryRays rays = new(4);
        rays.Start(queue);
        Write(queue, rays.Refract(3), 31);
        Write(queue, rays.Reflect(3), 30);
        rays.EndLayer(4);
        Write(queue, rays.Reflect(3), 32);
        Write(queue, rays.Reflect(1), 10);
        rays.EndLayer(4);
        Write(queue, rays.Reflect(3), 33);
        rays.LineUp(4);
        Assert.Equal([10, 30, 31, 32, 33], Pixels(queue));
        Assert.Equal([10, 30, 31, 32, 33], Enumerable.Range(0, queue.Count).Select(i => queue.Differential(i).OriginDx.X));
    }

    [Fact]
    public void Queue_MoreRaysThanItHadRoomFor_KeepsAll()
    {
        SecondaryQueue queue = new(hasDifferentials: true);
        SecondaryRays rays = new(5000);
        rays.Start(queue);
        for (int ray = 4999; ray >= 0; ray--)
        {
            Write(queue, rays.Reflect(ray), ray);
        }

        rays.LineUp(5000);
        Assert.Equal(Enumerable.Range(0, 5000), Pixels(queue));
        Assert.Equal(1234, queue.Differential(1234).OriginDx.X);
    }

    private static void Write(SecondaryQueue queue, int place, int number, bool hasDifferentials = true)
    {
        queue.At(place).Pixel = number;
        if (hasDifferentials)
        {
            queue.DifferentialAt(place) = new RayDifferential(new Vector3D(number, 0, 0), default, default, default);
        }
    }

    private static int[] Pixels(SecondaryQueue queue) => [.. Enumerable.Range(0, queue.Count).Select(i => queue[i].Pixel)];
}
