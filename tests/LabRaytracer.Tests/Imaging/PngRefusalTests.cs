using System.Buffers.Binary;

namespace LabRaytracer.Tests;

public sealed class PngRefusalTests
{
    [Fact]
    public void Read_AnyDamagedByte_IsRefused()
    {
        // All bytes of this file are under a checksum or structure: no flip may pass.
        byte[] file = PngReadTests.Create(2, 8, false, 5, 4, false).ToBytes();
        for (int i = 0; i < file.Length; i++)
        {
            byte[] damaged = (byte[])file.Clone();
            damaged[i] ^= 0x10;
            Assert.Throws<PictureFormatException>(() => PngReadTests.Read(damaged));
        }
    }

    [Fact]
    public void Read_AnyCut_IsRefused()
    {
        byte[] file = PngReadTests.Create(3, 4, true, 9, 9, true).ToBytes();
        for (int length = 0; length < file.Length; length++)
        {
            Assert.Throws<PictureFormatException>(() => PngReadTests.Read(file[..length]));
        }
    }

    [Theory]
    [InlineData(0, 3)]
    [InlineData(1, 8)]
    [InlineData(2, 4)]
    [InlineData(3, 16)]
    [InlineData(4, 4)]
    [InlineData(5, 8)]
    [InlineData(6, 1)]
    [InlineData(7, 8)]
    [InlineData(0, 0)]
    [InlineData(0, 99)]
    public void Read_ImpossibleColourTypeOrDepth_IsRefused(int type, int depth) =>
        AssertRefused("does not exist", Header(4, 4, (byte)depth, (byte)type, 0, 0, 0), ("IDAT", TestPng.Deflate(new byte[100])));

    [Theory]
    [InlineData(1, 0, 0)]
    [InlineData(0, 1, 0)]
    [InlineData(0, 0, 2)]
    public void Read_UnknownMethod_IsRefused(byte compression, byte filter, byte interlace) =>
        AssertRefused("is not known", Header(4, 4, 8, 0, compression, filter, interlace), ("IDAT", TestPng.Deflate(new byte[20])));

    [Theory]
    [InlineData(0, 5, "not possible")]
    [InlineData(5, 0, "not possible")]
    [InlineData(1048577, 1, "limit")]
    [InlineData(-1, 1, "limit")]
    [InlineData(65536, 65536, "limit")]
    [InlineData(8193, 8193, "limit")]
    public void Read_SizeOutOfRange_IsRefusedBeforeMemoryIsTaken(int width, int height, string reason)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        AssertRefused(reason, Header(width, height, 8, 6, 0, 0, 0), ("IDAT", TestPng.Deflate(new byte[5])));
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 2_000_000);
    }

    [Fact]
    public void Read_LargeSizeAndNoPixels_TakesNoMemory()
    {
        Assert.InRange(Allocated(() => AssertRefused("too early", Header(8000, 8000, 8, 6, 0, 0, 0), ("IDAT", TestPng.Deflate(new byte[5])))), 0, 2_000_000);
    }

    [Fact]
    public void Read_BombInPixelsAndProfile_IsNotInflatedIntoMemory()
    {
        const int Size = 50_000_000, Most = 1 << 22;
        byte[] bomb = TestPng.Deflate(new byte[Size]);
        Assert.InRange(bomb.Length, 1, Size / 100);
        Assert.InRange(Allocated(() => AssertRefused("more pixels", Header(4, 4, 8, 0, 0, 0, 0), ("IDAT", bomb))), 0, Most);
        AssertRefused("limit", Header(4, 4, 8, 0, 0, 0, 0), ("iCCP", new byte[(8 << 20) + 1]), ("IDAT", TestPng.Deflate(new byte[20])));

        // A profile below the limit is kept but never inflated.
        byte[] profiled = Build(Header(4, 4, 8, 0, 0, 0, 0), ("iCCP", [.. "x\0\0"u8, .. bomb]), ("IDAT", TestPng.Deflate(new byte[20])), ("IEND", []));
        Assert.InRange(Allocated(() => PngReadTests.Read(profiled)), 0, Most);
    }

    [Fact]
    public void Read_WrongOrderOfChunks_IsRefused()
    {
        (string, byte[]) header = Header(4, 4, 8, 0, 0, 0, 0);
        (string, byte[]) palette4 = ("PLTE", new byte[12]);
        (string, byte[]) data = ("IDAT", TestPng.Deflate(new byte[20]));
        (string, byte[]) indexed = Header(4, 4, 8, 3, 0, 0, 0);
        AssertRefused("first chunk", data);
        AssertRefused("before the pixels", header, header, data);
        AssertRefused("before the pixels", header, ("IEND", []));
        AssertRefused("palette", indexed, data);
        AssertRefused("PLTE", header, palette4, data);
        AssertRefused("PLTE", indexed, palette4, palette4, data);
        AssertRefused("PLTE", indexed, ("PLTE", new byte[13]), data);
        AssertRefused("PLTE", indexed, ("PLTE", []), data);
        AssertRefused("tRNS", indexed, ("tRNS", [1]), palette4, data);
        AssertRefused("tRNS", indexed, palette4, ("tRNS", [1, 2, 3, 4, 5]), data);
        AssertRefused("tRNS", header, data, ("tRNS", [0, 1]), ("IEND", []));
        AssertRefused("tRNS", Header(4, 4, 8, 6, 0, 0, 0), ("tRNS", [0, 1]), data);
        AssertRefused("gAMA", header, ("gAMA", [0, 0, 1, 0]), ("gAMA", [0, 0, 1, 0]), data);
        AssertRefused("gAMA", header, ("gAMA", [0, 0, 1]), data);
        AssertRefused("not known", header, ("ABCD", []), data);
        AssertRefused("IDAT", header, data, ("teXt", []), ("IDAT", []), ("IEND", []));
        AssertRefused("IEND", header, data, ("IEND", [1]));
        AssertRefused("none", header, ("ab1d", []), data);
    }

    [Fact]
    public void Read_WrongPixels_IsRefused()
    {
        (string, byte[]) header = Header(4, 4, 8, 0, 0, 0, 0);
        byte[] rows = new byte[20];
        rows[5] = 5;
        AssertRefused("filter 5", header, ("IDAT", TestPng.Deflate(rows)));
        AssertRefused("too early", header, ("IDAT", TestPng.Deflate(new byte[19])), ("IEND", []));
        AssertRefused("more pixels", header, ("IDAT", TestPng.Deflate(new byte[21])), ("IEND", []));
        byte[] wrongSum = TestPng.Deflate(new byte[20]);
        wrongSum[^1] ^= 1;
        AssertRefused("damaged", header, ("IDAT", wrongSum), ("IEND", []));
        byte[] index = new byte[20];
        index[1] = 4;
        AssertRefused("index 4", Header(4, 4, 8, 3, 0, 0, 0), ("PLTE", new byte[12]), ("IDAT", TestPng.Deflate(index)));
    }

    [Fact]
    public void Read_LargePictureWithTwoMistakes_NamesTheFirst()
    {
        // Row 500 has a filter that does not exist, and the rows end at 900 of 1000.
        byte[] rows = new byte[900 * 3001];
        rows[500 * 3001] = 7;
        AssertRefused("filter 7", Header(1000, 1000, 8, 2, 0, 0, 0), ("IDAT", TestPng.Deflate(rows)));
        rows[500 * 3001] = 0;
        AssertRefused("end too early", Header(1000, 1000, 8, 2, 0, 0, 0), ("IDAT", TestPng.Deflate(rows)));
    }

    private static (string Type, byte[] Content) Header(int width, int height, byte depth, byte type, byte compression, byte filter, byte interlace)
    {
        byte[] header = [0, 0, 0, 0, 0, 0, 0, 0, depth, type, compression, filter, interlace];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        return ("IHDR", header);
    }

    private static byte[] Build(params (string Type, byte[] Content)[] chunks)
    {
        MemoryStream file = new();
        file.Write(TestPng.Signature);
        foreach ((string type, byte[] content) in chunks)
        {
            TestPng.WriteChunk(file, type, content);
        }

        return file.ToArray();
    }

    private static void AssertRefused(string reason, params (string Type, byte[] Content)[] chunks)
    {
        PictureFormatException error = Assert.Throws<PictureFormatException>(() => PngReadTests.Read(Build(chunks)));
        Assert.Contains(reason, error.Message, StringComparison.Ordinal);
        Assert.Contains("test.png", error.Message, StringComparison.Ordinal);
        Assert.DoesNotContain('\n', error.Message);
    }

    /// <summary>Bytes that this thread allocates; pictures as small as these are read by one thread.</summary>
    private static long Allocated(Action action)
    {
        long before = GC.GetAllocatedBytesForCurrentThread();
        action();
        return GC.GetAllocatedBytesForCurrentThread() - before;
    }
}
