namespace LabRaytracer.Tests;

/// <summary>Lanes in another order.</summary>
public sealed unsafe class LaneOrderTests
{
    [Fact]
    public void Descending_AnyNumbers_AsSorted()
    {
        Random random = new(11);
        for (int round = 0; round < 2000; round++)
        {
            // Few different numbers in every second round, so that many are equal.
            int[] numbers = [.. Enumerable.Range(0, Int8.Width).Select(_ => round % 2 == 0 ? random.Next(int.MinValue, int.MaxValue) : random.Next(-2, 3))];
            Assert.Equal(numbers.OrderDescending(), Sorted(numbers));
        }
    }

    [Fact]
    public void Descending_ZerosAndOnes_AsSorted()
    {
        // A network that sorts these sorts everything (Knuth, "The art of computer programming", volume 3, 5.3.4).
        for (int bits = 0; bits < 1 << Int8.Width; bits++)
        {
            int[] numbers = [.. Enumerable.Range(0, Int8.Width).Select(lane => (bits >> lane) & 1)];
            Assert.Equal(numbers.OrderDescending(), Sorted(numbers));
        }
    }

    [Fact]
    public void At_PlacesWithHigherBits_LowestThreeCount()
    {
        int[] lanes = [10, 11, 12, 13, 14, 15, 16, 17], places = [7, 8 + 3, -8, 16 + 5, 0x7f800000 + 1, int.MinValue + 2, 6, 4], result = new int[Int8.Width];
        fixed (int* from = lanes, at = places, to = result)
        {
            Int8.Store(LaneOrder.At(Int8.Load(from), Int8.Load(at)), to);
        }

        Assert.Equal([17, 13, 10, 15, 11, 12, 16, 14], result);
    }

    private static int[] Sorted(int[] numbers)
    {
        int[] result = new int[Int8.Width];
        fixed (int* from = numbers, to = result)
        {
            Int8.Store(LaneOrder.Descending(Int8.Load(from)), to);
        }

        return result;
    }
}
