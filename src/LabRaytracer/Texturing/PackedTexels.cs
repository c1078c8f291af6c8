using System.Buffers;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>Opaque 8-bit colours, arranged so that neighbours lie near to each other in memory: for large pictures, whose lookups wait for it.</summary>
/// <remarks>
/// <para>A line of the cache holds 20 texels of a row, three bytes each, of which the last is the first of the next line: two neighbours are always read from one line.
/// Behind a row's last texel lies its first one. A page of memory holds 64 such lines, one below the other; the pages of 64 rows of the picture are a band.</para>
/// <para>The file's own array is rearranged, which is large enough: no more memory is needed. Immutable, thread safe.</para>
/// </remarks>
[SkipLocalsInit]
internal sealed unsafe class PackedTexels
{
    /// <summary>Texels that begin in a line.</summary>
    public const int LineTexels = 19;

    /// <summary>Bytes of a line.</summary>
    public const int LineBytes = 64;

    /// <summary>Bytes of a texel.</summary>
    public const int TexelBytes = 3;

    /// <summary>Lines of a page, one below the other: 2 to the power of this.</summary>
    public const int PageShift = 6;

    /// <summary>Bytes of a page.</summary>
    public const int PageBytes = LineBytes << PageShift;

    private const int LargestSide = 1 << 16;

    private readonly GCHandle _pin;

    private PackedTexels(PixelBuffer pixels, GCHandle pin)
    {
        (Width, Height, _pin) = (pixels.Width, pixels.Height, pin);
        Texels = Aligned(pin);
        BandBytes = BytesOfBand(Width);
        Pack((int*)pin.AddrOfPinnedObject());
    }

    ~PackedTexels() => _pin.Free();

    /// <summary>Number of columns.</summary>
    public int Width { get; }

    /// <summary>Number of rows.</summary>
    public int Height { get; }

    /// <summary>The first byte, at the start of a line.</summary>
    public byte* Texels { get; }

    /// <summary>Bytes of a band.</summary>
    public int BandBytes { get; }

    private int Columns => BandBytes / PageBytes;

    /// <summary>Rearranges a picture, whose samples are overwritten.</summary>
    /// <param name="pixels">The picture.</param>
    /// <returns>Null, and nothing is overwritten, where this cannot be done or is not worth it: small pictures, other samples, alpha, samples that somebody else holds.</returns>
    public static PackedTexels? Of(PixelBuffer pixels)
    {
        if (!pixels.IsOurs || pixels.HasAlpha || pixels.Rgba8 is not { } samples || !TexelStore.IsWorthCare(pixels.Width, pixels.Height)
            || pixels.Width > LargestSide || pixels.Height > LargestSide)
        {
            return null;
        }

        int bands = ((pixels.Height - 1) >> PageShift) + 1, band = BytesOfBand(pixels.Width);
        bool fits = band + LineBytes <= (4L * pixels.Width) << PageShift && ((long)bands * band) + LineBytes <= samples.Length;
        return fits ? new PackedTexels(pixels, GCHandle.Alloc(samples, GCHandleType.Pinned)) : null;
    }

    /// <summary>Where a texel lies.</summary>
    /// <param name="x">Column, [0, width).</param>
    /// <param name="row">Row, down, [0, height).</param>
    public byte* At(int x, int row) =>
        Texels + ((long)(row >> PageShift) * BandBytes) + ((x / LineTexels) * PageBytes) + ((row & ((1 << PageShift) - 1)) * LineBytes) + (TexelBytes * (x % LineTexels));

    /// <summary>The samples as they were in the file, four a texel.</summary>
    public byte[] Unpack()
    {
        byte[] samples = GC.AllocateUninitializedArray<byte>(4 * Width * Height);
        for (int row = 0, to = 0; row < Height; row++)
        {
            for (int x = 0; x < Width; x++, to += 4)
            {
                byte* from = At(x, row);
                (samples[to], samples[to + 1], samples[to + 2], samples[to + 3]) = (from[0], from[1], from[2], byte.MaxValue);
            }
        }

        return samples;
    }

    private static int BytesOfBand(int width) => (((width - 1) / LineTexels) + 1) * PageBytes;

    private static byte* Aligned(GCHandle pin) => (byte*)(((long)pin.AddrOfPinnedObject() + LineBytes - 1) / LineBytes * LineBytes);

    /// <summary>Band after band: each ends before the samples of the next one, as it is smaller.</summary>
    private void Pack(int* pixels)
    {
        int bandPixels = Width << PageShift;
        int[] copy = ArrayPool<int>.Shared.Rent(bandPixels);
        fixed (int* copied = copy)
        {
            for (int band = 0; band << PageShift < Height; band++)
            {
                int rows = Math.Min(Height - (band << PageShift), 1 << PageShift);
                int* from = pixels + ((long)band * bandPixels);
                byte* to = Texels + ((long)band * BandBytes);
                if (to + BandBytes > from)
                {
                    new ReadOnlySpan<int>(from, rows * Width).CopyTo(copy);
                    from = copied;
                }

                for (int row = 0; row < rows; row++)
                {
                    PackRow(from + (row * Width), to + (row * LineBytes));
                }
            }
        }

        ArrayPool<int>.Shared.Return(copy);
    }

    private void PackRow(int* row, byte* to)
    {
        int column = 0;
        for (; (column + 1) * LineTexels < Width; column++)
        {
            ByteTriples.PackTwenty(row + (column * LineTexels), to + (column * PageBytes));
        }

        int* last = stackalloc int[LineTexels + 1];
        for (; column < Columns; column++)
        {
            for (int k = 0; k <= LineTexels; k++)
            {
                last[k] = row[((column * LineTexels) + k) % Width];
            }

            ByteTriples.PackTwenty(last, to + (column * PageBytes));
        }
    }
}
