namespace LabRaytracer.Tests.Numerics;

/// <summary>The sequence that samples of lamps and lenses come from.</summary>
public sealed class SquareSequenceTests
{
    [Fact]
    public void Points_FirstEight_AreSobols()
    {
        // Digits in base 2 mirrored; columns of Pascal's triangle modulo 2: 1/2, 3/4, 5/8.
        double[] first = [0, 0.5, 0.25, 0.75, 0.125, 0.625, 0.375, 0.875], second = [0, 0.5, 0.75, 0.25, 0.625, 0.125, 0.375, 0.875];
        for (uint number = 0; number < 8; number++)
        {
            Assert.Equal(first[number] * 4294967296.0, SquareSequence.First(number));
            Assert.Equal(second[number] * 4294967296.0, SquareSequence.Second(number));
        }
    }

    [Theory]
    [InlineData(1u)]
    [InlineData(0x80000000u)]
    [InlineData(0xFFFFFFFFu)]
    [InlineData(0x9E3779B9u)]
    [InlineData(123456789u)]
    public void Second_AnyNumber_SumOfTheColumnsOfPascalsTriangle(uint number)
    {
        // Column k of the triangle modulo 2: binomial(k, digit) is odd where the digit's bits are all bits of k, too (Lucas).
        uint expected = 0;
        for (int k = 0; k < 32; k++)
        {
            for (int digit = 0; digit < 32; digit++)
            {
                expected ^= (number >> k & 1) != 0 && (digit & ~k) == 0 ? 1u << (31 - digit) : 0;
            }
        }

        Assert.Equal(expected, SquareSequence.Second(number));
    }

    [Theory]
    [InlineData(0, 0u, 0u, 0u)]
    [InlineData(4, 0u, 0u, 0u)]
    [InlineData(6, 64u, 0u, 0u)]
    [InlineData(8, 256u * 77, 0xDEADBEEFu, 0x12345678u)]
    [InlineData(5, 32u * 1000, 0x9E3779B9u, 0xFFFFFFFFu)]
    public void Points_BlockOfAPowerOfTwo_OneInEachCellOfEveryGrid(int power, uint start, uint scrambleFirst, uint scrambleSecond)
    {
        for (int across = 0; across <= power; across++)
        {
            HashSet<(ulong, ulong)> cells = [];
            for (uint number = start; number < start + (1u << power); number++)
            {
                ulong first = SquareSequence.First(number) ^ scrambleFirst, second = SquareSequence.Second(number) ^ scrambleSecond;
                cells.Add((first >> (32 - across), second >> (32 - power + across)));
            }

            Assert.Equal(1 << power, cells.Count);
        }
    }

    [Fact]
    public void Unit_EndsOfTheRange_StayInside()
    {
        Assert.Equal(0.5 / (1 << 23), SquareSequence.Unit<Double1, Float1, Int1>(new Int1(0)).Value);
        Assert.Equal(1 - (0.5 / (1 << 23)), SquareSequence.Unit<Double1, Float1, Int1>(new Int1(-1)).Value);
        Assert.Equal(1 - (0.5 / (1 << 23)), (double)SquareSequence.Unit<Float1, Float1, Int1>(new Int1(-1)).Value);
        Assert.InRange(SquareSequence.Unit(uint.MaxValue), 0.999999999, Math.BitDecrement(1.0));
        Assert.InRange(SquareSequence.Unit(0u), double.Epsilon, 1e-9);
    }
}
