using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>The samples of a picture file as stored, and what they mean: four channels, row 0 on top of the picture.</summary>
/// <remarks>
/// Samples of pixel (x, y) start at 4 (y * Width + x), in the order red, green, blue, alpha; alpha is not multiplied into the colours.
/// Grey files are expanded to three equal colours. The arrays are not copied; once they are no longer written to, a buffer is thread safe.
/// </remarks>
public sealed class PixelBuffer
{
    private PixelBuffer(int width, int height, PixelFormat format, Array samples, TransferFunction transfer, string transferSource)
    {
        ArgumentNullException.ThrowIfNull(samples);
        ArgumentNullException.ThrowIfNull(transferSource);
        PictureSize.Check(width, height);
        if (samples.Length != 4L * width * height)
        {
            throw new ArgumentException(
                $"The buffer has {samples.Length} samples; {width} x {height} pixels of four channels need {4L * width * height}.",
                nameof(samples));
        }

        (Width, Height, Format, Transfer, TransferSource) = (width, height, format, transfer, transferSource);
        Rgba8 = samples as byte[];
        Rgba16 = samples as ushort[];
        RgbaFloat = samples as float[];
    }

    private PixelBuffer(PixelBuffer other, Array? samples)
    {
        (Width, Height, Format, Transfer, TransferSource) = (other.Width, other.Height, other.Format, other.Transfer, other.TransferSource);
        (HasAlpha, IsGrey) = (other.HasAlpha, other.IsGrey);
        Rgba8 = samples as byte[];
        Rgba16 = samples as ushort[];
        RgbaFloat = samples as float[];
    }

    /// <summary>Columns, in [1, 1048576].</summary>
    public int Width { get; }

    /// <summary>Rows, in [1, 1048576].</summary>
    public int Height { get; }

    /// <summary>Which of the three arrays is there.</summary>
    public PixelFormat Format { get; }

    /// <summary>What the colour samples mean as light; alpha is always linear.</summary>
    public TransferFunction Transfer { get; }

    /// <summary>Where <see cref="Transfer"/> comes from, for people: "sRGB chunk", "gAMA chunk", "assumed", ...</summary>
    public string TransferSource { get; }

    /// <summary>Whether any sample of alpha is below opaque (255, 65535 or 1).</summary>
    public bool HasAlpha { get; private init; }

    /// <summary>Whether red, green and blue are equal in every pixel.</summary>
    public bool IsGrey { get; private init; }

    /// <summary>The samples when <see cref="Format"/> is <see cref="PixelFormat.Rgba8"/>, otherwise null.</summary>
    public byte[]? Rgba8 { get; }

    /// <summary>The samples when <see cref="Format"/> is <see cref="PixelFormat.Rgba16"/>, otherwise null.</summary>
    public ushort[]? Rgba16 { get; }

    /// <summary>The samples when <see cref="Format"/> is <see cref="PixelFormat.RgbaFloat"/>, otherwise null.</summary>
    public float[]? RgbaFloat { get; }

    /// <summary>Whether nobody else holds the samples, so that whoever gets the buffer may overwrite them.</summary>
    internal bool IsOurs { get; private init; }

    /// <summary>Wraps 8-bit samples.</summary>
    /// <param name="width">Columns, in [1, 1048576].</param>
    /// <param name="height">Rows, in [1, 1048576].</param>
    /// <param name="samples">4 * width * height samples; kept, not copied.</param>
    /// <param name="transfer">What the colours mean.</param>
    /// <param name="transferSource">Where <paramref name="transfer"/> comes from, for people.</param>
    /// <exception cref="ArgumentOutOfRangeException">A side is outside of its range.</exception>
    /// <exception cref="ArgumentException">The number of samples is wrong.</exception>
    public static PixelBuffer FromRgba8(int width, int height, byte[] samples, TransferFunction transfer, string transferSource) =>
        new(width, height, PixelFormat.Rgba8, samples, transfer, transferSource)
        {
            HasAlpha = AnyBelow<byte>(samples, byte.MaxValue),
            IsGrey = AllGrey<byte>(samples),
        };

    /// <summary>Wraps 16-bit samples; otherwise as <see cref="FromRgba8"/>.</summary>
    /// <param name="width">Columns, in [1, 1048576].</param>
    /// <param name="height">Rows, in [1, 1048576].</param>
    /// <param name="samples">4 * width * height samples; kept, not copied.</param>
    /// <param name="transfer">What the colours mean.</param>
    /// <param name="transferSource">Where <paramref name="transfer"/> comes from, for people.</param>
    /// <exception cref="ArgumentOutOfRangeException">A side is outside of its range.</exception>
    /// <exception cref="ArgumentException">The number of samples is wrong.</exception>
    public static PixelBuffer FromRgba16(int width, int height, ushort[] samples, TransferFunction transfer, string transferSource) =>
        new(width, height, PixelFormat.Rgba16, samples, transfer, transferSource)
        {
            HasAlpha = AnyBelow<ushort>(samples, ushort.MaxValue),
            IsGrey = AllGrey<ushort>(samples),
        };

    /// <summary>Wraps float samples; otherwise as <see cref="FromRgba8"/>.</summary>
    /// <param name="width">Columns, in [1, 1048576].</param>
    /// <param name="height">Rows, in [1, 1048576].</param>
    /// <param name="samples">4 * width * height samples; kept, not copied.</param>
    /// <param name="transfer">What the colours mean.</param>
    /// <param name="transferSource">Where <paramref name="transfer"/> comes from, for people.</param>
    /// <exception cref="ArgumentOutOfRangeException">A side is outside of its range.</exception>
    /// <exception cref="ArgumentException">The number of samples is wrong.</exception>
    public static PixelBuffer FromRgbaFloat(int width, int height, float[] samples, TransferFunction transfer, string transferSource) =>
        new(width, height, PixelFormat.RgbaFloat, samples, transfer, transferSource)
        {
            HasAlpha = AnyBelow(samples, 1f),
            IsGrey = AllGrey<float>(samples),
        };

    /// <summary>The same samples, read with another transfer function: an explicit choice wins over what the file says.</summary>
    /// <param name="transfer">What the colours mean.</param>
    /// <param name="transferSource">Who says so, for people.</param>
    public PixelBuffer WithTransfer(TransferFunction transfer, string transferSource = "set explicitly") =>
        new(Width, Height, Format, (Array?)Rgba8 ?? (Array?)Rgba16 ?? RgbaFloat!, transfer, transferSource)
        {
            HasAlpha = HasAlpha,
            IsGrey = IsGrey,
        };

    /// <summary>The same samples, given away by the codec that made them.</summary>
    internal PixelBuffer GivenAway() => new(this, (Array?)Rgba8 ?? (Array?)Rgba16 ?? RgbaFloat) { IsOurs = true };

    /// <summary>What the samples mean, without them.</summary>
    internal PixelBuffer WithoutSamples() => new(this, null);

    private static bool AnyBelow<T>(ReadOnlySpan<T> samples, T opaque)
        where T : unmanaged, IComparable<T>
    {
        for (int i = 3; i < samples.Length; i += 4)
        {
            if (samples[i].CompareTo(opaque) < 0)
            {
                return true;
            }
        }

        return false;
    }

    private static bool AllGrey<T>(ReadOnlySpan<T> samples)
        where T : unmanaged, IEquatable<T>
    {
        foreach (Rgba<T> pixel in MemoryMarshal.Cast<T, Rgba<T>>(samples))
        {
            if (!pixel.R.Equals(pixel.G) || !pixel.G.Equals(pixel.B))
            {
                return false;
            }
        }

        return true;
    }

    [StructLayout(LayoutKind.Sequential)]
    private readonly record struct Rgba<T>(T R, T G, T B, T A)
        where T : unmanaged;
}
