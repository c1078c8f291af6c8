namespace LabRaytracer.Tests;

/// <summary>Uses the system's libturbojpeg; without it, the message that says how to get JPEG is tested instead.</summary>
public sealed class JpegTests
{
    // 8 x 8 pixels of one colour: (200, 100, 50), or grey 120.
    internal const string Baseline420 =
        "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAMCAgMCAgMDAwMEAwMEBQgFBQQEBQoHBwYIDAoMDAsKCwsNDhIQDQ4RDgsLEBYQERMUFRUVDA8XGBYUGBIUFRT/2wBDAQMEBAUEBQkFBQkUDQsNFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBT/wAARCAAIAAgDASIAAhEBAxEB/8QAFQABAQAAAAAAAAAAAAAAAAAAAAT/xAAUEAEAAAAAAAAAAAAAAAAAAAAA/8QAFQEBAQAAAAAAAAAAAAAAAAAABwj/xAAUEQEAAAAAAAAAAAAAAAAAAAAA/9oADAMBAAIRAxEAPwCQAHqQf//Z";

    internal const string Progressive =
        "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAMCAgMCAgMDAwMEAwMEBQgFBQQEBQoHBwYIDAoMDAsKCwsNDhIQDQ4RDgsLEBYQERMUFRUVDA8XGBYUGBIUFRT/2wBDAQMEBAUEBQkFBQkUDQsNFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBQUFBT/wgARCAAIAAgDAREAAhEBAxEB/8QAFAABAAAAAAAAAAAAAAAAAAAAA//EABUBAQEAAAAAAAAAAAAAAAAAAAYH/9oADAMBAAIQAxAAAAEQ9I//xAAUEAEAAAAAAAAAAAAAAAAAAAAA/9oACAEBAAEFAn//xAAUEQEAAAAAAAAAAAAAAAAAAAAA/9oACAEDAQE/AX//xAAUEQEAAAAAAAAAAAAAAAAAAAAA/9oACAECAQE/AX//xAAUEAEAAAAAAAAAAAAAAAAAAAAA/9oACAEBAAY/An//xAAUEAEAAAAAAAAAAAAAAAAAAAAA/9oACAEBAAE/IX//2gAMAwEAAgADAAAAEJ//xAAUEQEAAAAAAAAAAAAAAAAAAAAA/9oACAEDAQE/EH//xAAUEQEAAAAAAAAAAAAAAAAAAAAA/9oACAECAQE/EH//xAAUEAEAAAAAAAAAAAAAAAAAAAAA/9oACAEBAAE/EH//2Q==";

    private const string Grey =
        "/9j/4AAQSkZJRgABAQAAAQABAAD/2wBDAAMCAgMCAgMDAwMEAwMEBQgFBQQEBQoHBwYIDAoMDAsKCwsNDhIQDQ4RDgsLEBYQERMUFRUVDA8XGBYUGBIUFRT/wAALCAAIAAgBAREA/8QAFAABAAAAAAAAAAAAAAAAAAAABf/EABQQAQAAAAAAAAAAAAAAAAAAAAD/2gAIAQEAAD8AKf/Z";

    private const string Cmyk =
        "/9j/7gAOQWRvYmUAZAAAAAAC/9sAQwACAQEBAQECAQEBAgICAgIEAwICAgIFBAQDBAYFBgYGBQYGBgcJCAYHCQcGBggLCAkKCgoKCgYICwwLCgwJCgoK/9sAQwECAgICAgIFAwMFCgcGBwoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoKCgoK/8AAFAgACAAIBAERAAIRAQMRAQQRAP/EABUAAQEAAAAAAAAAAAAAAAAAAAcJ/8QAFBABAAAAAAAAAAAAAAAAAAAAAP/EABUBAQEAAAAAAAAAAAAAAAAAAAgJ/8QAFBEBAAAAAAAAAAAAAAAAAAAAAP/aAA4EAQACEQMRBAAAPwADNROtSB//2Q==";

    [Theory]
    [InlineData(Baseline420, 200, 100, 50)]
    [InlineData(Progressive, 200, 100, 50)]
    [InlineData(Grey, 120, 120, 120)]
    [InlineData(Cmyk, 200, 100, 50)]
    public void Read_OneColour_IsWithinFourCodes(string base64, int r, int g, int b)
    {
        if (!JpegCodec.IsAvailable)
        {
            AssertSaysHow();
            return;
        }

        PixelBuffer buffer = Read(Convert.FromBase64String(base64));
        Assert.Equal((8, 8), (buffer.Width, buffer.Height));
        for (int i = 0; i < 64; i++)
        {
            byte[] pixel = buffer.Rgba8!.AsSpan(4 * i, 4).ToArray();
            Assert.InRange(pixel[0], r - 4, r + 4);
            Assert.InRange(pixel[1], g - 4, g + 4);
            Assert.InRange(pixel[2], b - 4, b + 4);
            Assert.Equal(255, pixel[3]);
        }
    }

    [Fact]
    public void Read_CutAnywhere_IsRefused()
    {
        byte[] file = Convert.FromBase64String(Baseline420);
        for (int length = 3; length < file.Length - 2; length++)
        {
            Assert.Throws<PictureFormatException>(() => Read(file[..length]));
        }
    }

    [Fact]
    public void Read_OverTheLimit_IsRefused()
    {
        byte[] file = Convert.FromBase64String(Progressive);
        PictureLimits limits = new() { MaxPixels = 63 };
        Assert.Throws<PictureFormatException>(() => PictureCodecs.Default.Read(new MemoryStream(file), "a.jpg", limits));
    }

    private static void AssertSaysHow()
    {
        PictureFormatException error = Assert.Throws<PictureFormatException>(() => Read(Convert.FromBase64String(Grey)));
        Assert.Contains("libturbojpeg", error.Message, StringComparison.Ordinal);
        Assert.Contains("-p:UseImageSharp=true", error.Message, StringComparison.Ordinal);
    }

    private static PixelBuffer Read(byte[] file) => PictureCodecs.Default.Read(new MemoryStream(file), "test.jpg");
}
