namespace LabRaytracer.Tests;

/// <summary>Conversions, gathers and scalar access of the lane types, and the integer lanes.</summary>
public sealed unsafe class LaneConversionTests
{
    private static readonly double[] Numbers = [0.0, -0.0, 1, -1, 0.1, -2.9, 2.9, 1e9, -1e9, 16777217, 1e-320, 1e300, -1e-50, 0.49999999999999994, 7, 8];

    [Fact]
    public void Double1_Conversions_EqualScalar() => Check<Double1, Float1, Int1>();

    [Fact]
    public void Double4_Conversions_EqualScalar() => Check<Double4, Float4, Int4>();

    [Fact]
    public void Double8_Conversions_EqualScalar() => Check<Double8, Float8, Int8>();

    [Fact]
    public void Double16_Conversions_EqualScalar() => Check<Double16, Float16, Int16>();

    [Fact]
    public void Float1_Conversions_EqualScalar() => Check<Float1, Float1, Int1>();

    [Fact]
    public void Float4_Conversions_EqualScalar() => Check<Float4, Float4, Int4>();

    [Fact]
    public void Float8_Conversions_EqualScalar() => Check<Float8, Float8, Int8>();

    [Fact]
    public void Float16_Conversions_EqualScalar() => Check<Float16, Float16, Int16>();

    private static void Check<R, F, I>()
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Assert.Equal((R.Width, R.Width), (F.Width, I.Width));
        using LaneColumn<R> column = new(Numbers);
        for (int packet = 0; packet < column.Packets; packet++)
        {
            R lanes = column.Lanes[packet];
            for (int lane = 0; lane < R.Width; lane++)
            {
                double number = column[(packet * R.Width) + lane];
                UlpAssert.SameBits(number, R.Get(lanes, lane));
                UlpAssert.SameBits((float)number, F.Get(R.ToSingle(lanes), lane));
                UlpAssert.SameBits((float)number, R.Get(R.FromSingle(R.ToSingle(lanes)), lane));
                UlpAssert.SameBits(number, R.Take(column.Lanes, (packet * R.Width) + lane));
                UlpAssert.SameBits(number, R.Get(R.Broadcast(column.Lanes, (packet * R.Width) + lane), R.Width - 1));
                if (Math.Abs(number) < 2e9)
                {
                    Assert.Equal((int)number, I.Get(R.ToInt32(lanes), lane));
                    Assert.Equal(R.IsSingle ? (float)(int)number : (double)(int)number, R.Get(R.FromInt32(I.Of((int)number)), lane));
                }
            }
        }

        R.Put(column.Lanes, 5, 0.75);
        Assert.Equal(0.75, R.Take(column.Lanes, 5));
        MasksAndGathers<R, F, I>(column);
        Integers<I>();
    }

    private static void MasksAndGathers<R, F, I>(LaneColumn<R> column)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        I backwards = I.Of(15) - I.Iota(0);
        R gathered = R.Gather(column.Lanes, backwards);
        for (int lane = 0; lane < R.Width; lane++)
        {
            UlpAssert.SameBits(column[15 - lane], R.Get(gathered, lane));
            R mask = R.Equal(R.Iota(0), R.Of(lane));
            uint bit = 1u << lane;
            Assert.Equal(bit, F.Bits(R.MaskToSingle(mask)));
            Assert.Equal(bit, R.Bits(R.MaskFromSingle(R.MaskToSingle(mask))));
            Assert.Equal(bit, R.Bits(R.MaskFromInt32(R.MaskToInt32(mask))));
            Assert.Equal(-1, I.Get(R.MaskToInt32(mask), lane));
            Assert.True(R.All(R.Select(mask, R.True, ~mask)));
        }
    }

    private static void Integers<I>()
        where I : unmanaged, IIndexLane<I>
    {
        int[] hard = [0, 1, -1, 2, 3, 7, 100, -100, 46341, int.MaxValue, int.MinValue, 255, 256, 65535, 65536, 12345678];
        int[] stored = new int[16];
        fixed (int* numbers = hard, results = stored)
        {
            I rows = I.Iota(0);
            I all = I.Load(numbers);
            I.Store(I.Gather(numbers, rows), results);
            for (int lane = 0; lane < I.Width; lane++)
            {
                int a = hard[lane];
                Assert.Equal(a, stored[lane]);
                foreach (int b in hard)
                {
                    I other = I.Of(b);
                    int[] expected =
                    [
                        unchecked(a + b), unchecked(a - b), unchecked(a * b), a & b, a | b, a ^ b, ~a, Math.Min(a, b), Math.Max(a, b),
                        a < b ? -1 : 0, a == b ? -1 : 0, a < b ? a : b, a >>> 3,
                    ];
                    I[] found =
                    [
                        all + other, all - other, all * other, all & other, all | other, all ^ other, ~all, I.Min(all, other), I.Max(all, other),
                        I.Less(all, other), I.Equal(all, other), I.Select(I.Less(all, other), all, other), I.ShiftRight(all, 3),
                    ];
                    Assert.Equal(expected, found.Select(lanes => I.Get(lanes, lane)));
                }
            }
        }
    }
}
