using System.Text;

namespace LabRaytracer.Tests;

/// <summary>Seeded damage to valid files: only <see cref="PictureFormatException"/> may come out of a reader.</summary>
public sealed class ReaderFuzzTests
{
    private const int CasesPerReader = 3000;
    private static readonly PictureLimits Limits = new() { MaxPixels = 1 << 16, MaxChunkBytes = 1 << 16 };

    [Fact]
    public void Png_Damaged_OnlyRefuses()
    {
        List<byte[]> seeds = [];
        foreach ((int type, int depth, bool interlaced) in new[] { (0, 1, true), (2, 8, false), (3, 4, false), (4, 16, true), (6, 8, true) })
        {
            seeds.Add(PngReadTests.Create(type, depth, interlaced, 9, 7, withTransparency: type < 4, idatSize: 40).ToBytes());
        }

        Fuzz(new PngCodec(), seeds, 1);

        // Most damage ends at a checksum; with the sums put right again it gets deeper.
        Fuzz(new PngCodec(), seeds, 2, RepairPngSums);
    }

    [Fact]
    public void Netpbm_Damaged_OnlyRefuses()
    {
        byte[][] seeds = [.. new[] { "P2 3 2 255 1 2 3 4 5 6", "P3 #c\n1 1 9 1 2 3", "P5 4 2 255\nabcdefgh", "P6 1 1 999\n\u0001a\u0002b\u0003c" }.Select(Encoding.ASCII.GetBytes)];
        Fuzz(new NetpbmCodec(), seeds, 3);
        Fuzz(new PfmCodec(), [.. new[] { "Pf 1 2 1.0\nabcdefgh", "PF 1 1 -1.0\nabcdefghijkl" }.Select(Encoding.ASCII.GetBytes)], 4);
    }

    [Fact]
    public void Hdr_Damaged_OnlyRefuses()
    {
        MemoryStream file = new();
        new HdrCodec().Write(PngWriteTests.Pattern(20, 4), file, PictureSaveOptions.Default);
        byte[] old = [.. "#?RADIANCE\nEXPOSURE=2\n\n+X 2 -Y 3\n"u8, 9, 9, 9, 99, 1, 1, 1, 2, 3, 4, 5, 130, 1, 1, 1, 1, 7, 8, 9, 120];
        Fuzz(new HdrCodec(), [file.ToArray(), old], 5);
    }

    [Fact]
    public void Jpeg_Damaged_OnlyRefuses()
    {
        byte[] file = Convert.FromBase64String(JpegTests.Baseline420);
        byte[] progressive = Convert.FromBase64String(JpegTests.Progressive);
        Fuzz(new JpegCodec(), [file, progressive], 6);
    }

    private static void Fuzz(IPictureCodec codec, IReadOnlyList<byte[]> seeds, int seed, Action<byte[]>? repair = null)
    {
        Random random = new(seed);
        foreach (byte[] valid in seeds)
        {
            codec.Read(new MemoryStream(valid), Limits, "valid");
        }

        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < CasesPerReader; i++)
        {
            byte[] damaged = Damage(seeds[i % seeds.Count], random);
            repair?.Invoke(damaged);
            try
            {
                codec.Read(new MemoryStream(damaged), Limits, "fuzz");
            }
            catch (PictureFormatException error)
            {
                Assert.DoesNotContain('\n', error.Message);
            }
        }

        // At most 2^16 pixels of 16 bytes would be 1 MB a case; typical is far less.
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, CasesPerReader * 400_000L);
    }

    private static byte[] Damage(byte[] valid, Random random)
    {
        byte[] result = (byte[])valid.Clone();
        for (int n = random.Next(1, 4); n > 0; n--)
        {
            int at = random.Next(result.Length);
            switch (random.Next(5))
            {
                case 0:
                    result[at] ^= (byte)(1 << random.Next(8));
                    break;
                case 1:
                    result[at] = (byte)random.Next(256);
                    break;
                case 2:
                    result[at] = random.Next(2) == 0 ? (byte)0 : (byte)255;
                    break;
                case 3:
                    result = result[..Math.Max(1, at)];
                    break;
                default:
                    result = [.. result[..at], .. result[random.Next(result.Length)..]];
                    result = result.Length == 0 ? [0] : result;
                    break;
            }
        }

        return result;
    }

    /// <summary>Writes right checksums wherever a chunk can be made out.</summary>
    private static void RepairPngSums(byte[] file)
    {
        for (int at = 8; at + 12 <= file.Length;)
        {
            long length = ((long)file[at] << 24) | ((long)file[at + 1] << 16) | ((long)file[at + 2] << 8) | file[at + 3];
            if (at + 12 + length > file.Length)
            {
                return;
            }

            uint crc = Crc32.Append(0, file.AsSpan(at + 4, 4 + (int)length));
            int end = at + 8 + (int)length;
            (file[end], file[end + 1], file[end + 2], file[end + 3]) = ((byte)(crc >> 24), (byte)(crc >> 16), (byte)(crc >> 8), (byte)crc);
            at = end + 4;
        }
    }
}
