using System.Diagnostics;
using System.IO.Compression;
using System.Text;

namespace LabRaytracer.Tests;

public sealed class PngWriteTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(3, 2)]
    [InlineData(257, 50)]
    [InlineData(100, 60)]
    [InlineData(1, 900)]
    [InlineData(9000, 2)]
    public void Write_EveryDepthEncodingAndCompression_ReadsBackTheSameCodes(int width, int height)
    {
        Picture picture = Pattern(width, height);
        foreach (int depth in new[] { 8, 16 })
        {
            foreach (PngCompression compression in Enum.GetValues<PngCompression>())
            {
                foreach (TransferFunction encoding in new[] { TransferFunction.Srgb, TransferFunction.Linear, TransferFunction.Gamma(2.2) })
                {
                    PictureSaveOptions options = new() { BitDepth = depth, PngCompression = compression, Encoding = encoding };
                    PixelBuffer buffer = PngReadTests.Read(Write(picture, options));
                    Assert.Equal(encoding.ToString(), buffer.Transfer.ToString());
                    AssertCodes(picture, buffer, encoding, depth);
                }
            }
        }
    }

    [Fact]
    public void Write_RowsInAnyPortions_GivesTheSameBytes()
    {
        Picture picture = Pattern(300, 900);
        byte[] whole = Write(picture, PictureSaveOptions.Default);
        foreach (int rows in new[] { 1, 7, 291, 292, 500 })
        {
            MemoryStream file = new();
            PngRowWriter writer = new(file, 300, 900, PictureSaveOptions.Default);
            for (int y = 0; y < 900; y += rows)
            {
                writer.WriteRows(picture.Memory.Slice(y * 300, Math.Min(rows, 900 - y) * 300));
            }

            writer.Finish();
            Assert.Equal(whole, file.ToArray());
        }

        byte[] codes = PngReadTests.Read(whole).Rgba8!;
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            Intensity light = picture.Pixels[i];
            byte[] expected = [ColorEncoding.Srgb8FromLinear(light.R), ColorEncoding.Srgb8FromLinear(light.G), ColorEncoding.Srgb8FromLinear(light.B), 255];
            Assert.True(codes.AsSpan(4 * i, 4).SequenceEqual(expected));
        }
    }

    [Fact]
    public void Finish_RowsMissing_Throws()
    {
        PngRowWriter writer = new(new MemoryStream(), 10, 10, PictureSaveOptions.Default);
        writer.WriteRows(new Intensity[90]);
        Assert.Throws<InvalidOperationException>(writer.Finish);
    }

    [Fact]
    public void Write_ManyBands_FormOneZlibStreamWithARightChecksum()
    {
        byte[] file = Write(Pattern(500, 1000), PictureSaveOptions.Default);
        MemoryStream data = new();
        for (int at = 8; at < file.Length;)
        {
            int length = (file[at] << 24) | (file[at + 1] << 16) | (file[at + 2] << 8) | file[at + 3];
            Assert.InRange(length, 0, 1 << 20);
            if (Encoding.ASCII.GetString(file, at + 4, 4) == "IDAT")
            {
                data.Write(file, at + 8, length);
            }

            at += length + 12;
        }

        data.Position = 0;
        MemoryStream raw = new();
        using ZLibStream zlib = new(data, CompressionMode.Decompress);
        zlib.CopyTo(raw);
        Assert.Equal(1501 * 1000, raw.Length);
        Assert.Equal(data.Length, data.Position);
    }

    /// <summary>pngcheck is asked when it is installed; without it there is nothing to compare with and the test returns.</summary>
    [Fact]
    public void Write_AllOptions_SatisfiesPngcheck()
    {
        using TestFolder folder = new();
        List<string> files = [];
        foreach (PngCompression compression in Enum.GetValues<PngCompression>())
        {
            foreach (int depth in new[] { 8, 16 })
            {
                files.Add(folder[$"{compression}{depth}.png"]);
                PictureSaveOptions options = new()
                {
                    BitDepth = depth,
                    PngCompression = compression,
                    Encoding = depth == 8 ? TransferFunction.Srgb : TransferFunction.Linear,
                    Text = [new("Software", "test"), new("Title", "Kula ziemska: żółw"), new("Comment", "zwei\nZeilen ä")],
                };
                Pattern(640, 480).Save(files[^1], options);
            }
        }

        if (!File.Exists("/usr/bin/pngcheck"))
        {
            return;
        }

        using Process check = Process.Start(new ProcessStartInfo("/usr/bin/pngcheck", ["-q", .. files]) { RedirectStandardOutput = true })!;
        string output = check.StandardOutput.ReadToEnd();
        check.WaitForExit();
        Assert.True(check.ExitCode == 0 && output.Length == 0, output);
    }

    [Fact]
    public void Write_CommaCulture_GivesTheSameBytes()
    {
        System.Globalization.CultureInfo before = System.Globalization.CultureInfo.CurrentCulture;
        Picture picture = Pattern(20, 10);
        foreach (IPictureCodec codec in PictureCodecs.Default.Codecs.Where(codec => codec.CanWrite))
        {
            MemoryStream plain = new();
            MemoryStream comma = new();
            try
            {
                codec.Write(picture, plain, PictureSaveOptions.Default);
                System.Globalization.CultureInfo.CurrentCulture = new("pl-PL");
                codec.Write(picture, comma, PictureSaveOptions.Default);
                comma.Position = 0;
                codec.Read(comma, PictureLimits.Default, "comma");
            }
            finally
            {
                System.Globalization.CultureInfo.CurrentCulture = before;
            }

            Assert.Equal(plain.ToArray(), comma.ToArray());
        }
    }

    [Fact]
    public void Adler32_CombinedParts_EqualsTheWhole()
    {
        byte[] data = new byte[20000];
        new Random(1).NextBytes(data);
        foreach (int cut in new[] { 0, 1, 5552, 19999, 20000 })
        {
            uint combined = Adler32.Combine(Adler32.Compute(data.AsSpan(0, cut)), Adler32.Compute(data.AsSpan(cut)), 20000 - cut);
            Assert.Equal(Adler32.Compute(data), combined);
        }

        // RFC 1950 has no example; "Wikipedia" and its sum are the usual one.
        Assert.Equal(0x11E60398u, Adler32.Compute("Wikipedia"u8));
    }

    [Fact]
    public void Adler32_AnyLength_IsTheSumOfRfc1950()
    {
        byte[] data = new byte[12000];
        new Random(2).NextBytes(data);
        data.AsSpan(3000, 6000).Fill(255);
        foreach (int length in new[] { 0, 1, 15, 16, 31, 32, 33, 63, 64, 100, 5551, 5552, 5553, 12000 })
        {
            // Section 8.2 of RFC 1950, byte by byte.
            ulong a = 1, b = 0;
            foreach (byte value in data.AsSpan(0, length))
            {
                a = (a + value) % 65521;
                b = (b + a) % 65521;
            }

            Assert.Equal((uint)((b << 16) | a), Adler32.Compute(data.AsSpan(0, length)));
        }
    }

    [Fact]
    public void Encode_LinearLightAroundEveryThreshold_GivesTheExactCode()
    {
        // Code k begins at (2k - 1) / 510; the floats next to it on both sides must fall on their own sides, as they do in integers: floor((510 light + 1) / 2), where light is a multiple of 2^-40.
        List<float> lights = [float.NaN, float.NegativeInfinity, -1, -0f, 0, float.Epsilon, 1, 1.0000001f, 2, float.PositiveInfinity];
        List<int> codes = [0, 0, 0, 0, 0, 0, 255, 255, 255, 255];
        for (int code = 1; code <= 255; code++)
        {
            float near = ((2 * code) - 1) / 510f;
            foreach (float light in new[] { MathF.BitDecrement(near), near, MathF.BitIncrement(near) })
            {
                lights.Add(light);
                codes.Add((int)(((510 * (long)Math.ScaleB(light, 40)) + (1L << 40)) >> 41));
            }
        }

        while (lights.Count % 3 != 0)
        {
            lights.Add(0.5f);
            codes.Add(128);
        }

        Intensity[] row = [.. Enumerable.Range(0, lights.Count / 3).Select(x => new Intensity(lights[3 * x], lights[(3 * x) + 1], lights[(3 * x) + 2]))];
        byte[] target = new byte[lights.Count];
        new RowEncoder(TransferFunction.Linear, 8, ToneMapping.Default).Encode(row, 0, target);
        Assert.Equal(codes, target.Select(code => (int)code));
    }

    internal static Picture Pattern(int width, int height)
    {
        Picture picture = new(width, height);
        Random random = new(width + (7 * height));
        for (int y = 0; y < height; y++)
        {
            for (int x = 0; x < width; x++)
            {
                float smooth = ((x % 97) + (y % 89)) / 186f;
                picture[x, y] = new Intensity(smooth, random.NextSingle(), x % 13 == 0 ? 1.5f : smooth * smooth);
            }
        }

        return picture;
    }

    internal static byte[] Write(Picture picture, PictureSaveOptions options)
    {
        MemoryStream file = new();
        new PngCodec().Write(picture, file, options);
        return file.ToArray();
    }

    private static void AssertCodes(Picture picture, PixelBuffer buffer, TransferFunction encoding, int depth)
    {
        int max = (1 << depth) - 1;
        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            Intensity light = picture.Pixels[i];
            foreach ((int c, float value) in new[] { (0, light.R), (1, light.G), (2, light.B) })
            {
                int code = depth == 8 ? buffer.Rgba8![(4 * i) + c] : buffer.Rgba16![(4 * i) + c];

                // Half a code; a tie moves by the rounding of the double arithmetic and by the branch constants of sRGB having few digits.
                double exact = encoding.Encode(Math.Min(value, 1)) * max;
                if (Math.Abs(code - exact) > 0.5 + 1e-6)
                {
                    Assert.Fail($"pixel {i}, component {c}: code {code}, exact {exact}");
                }
            }
        }
    }
}
