using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>The texels of a texture, in the file's own format and row order (row 0 on top), pinned for gathers, or packed for bilinear lookups.</summary>
/// <remarks>Immutable but for the smaller versions that it keeps and for rows that it unpacks, thread safe.</remarks>
internal sealed unsafe class TexelStore
{
    private readonly Dictionary<object, MipPyramid> _pyramids = [];
    private PixelBuffer? _pixels;
    private GCHandle _pin;

    /// <param name="pixels">The picture.</param>
    /// <param name="forPairs">Whether it will be read bilinearly: then it is packed for that, if it is large.</param>
    public TexelStore(PixelBuffer pixels, bool forPairs = false)
    {
        Packed = forPairs ? PackedTexels.Of(pixels) : null;
        Facts = pixels.WithoutSamples();
        _pixels = Packed is null ? pixels : null;
    }

    ~TexelStore()
    {
        if (_pin.IsAllocated)
        {
            _pin.Free();
        }
    }

    /// <summary>What the texels mean, without them.</summary>
    public PixelBuffer Facts { get; }

    /// <summary>The texels packed for bilinear lookups; null if they are not.</summary>
    public PackedTexels? Packed { get; }

    /// <summary>Number of columns.</summary>
    public int Width => Facts.Width;

    /// <summary>Number of rows.</summary>
    public int Height => Facts.Height;

    /// <summary>Element number of texel (0, 0), the bottom-left one: rows go up, so the stride is minus the width.</summary>
    public int Start => (Height - 1) * Width;

    /// <summary>Tells whether texels are seldom in the processor's own cache.</summary>
    public bool IsLarge => IsWorthCare(Width, Height);

    /// <summary>The first sample of the top-left texel. Packed texels are unpacked for it, and stay so.</summary>
    public void* Samples
    {
        get
        {
            lock (_pyramids)
            {
                if (!_pin.IsAllocated)
                {
                    _pixels ??= PixelBuffer.FromRgba8(Width, Height, Packed!.Unpack(), Facts.Transfer, Facts.TransferSource);
                    _pin = GCHandle.Alloc((Array?)_pixels.Rgba8 ?? (Array?)_pixels.Rgba16 ?? _pixels.RgbaFloat, GCHandleType.Pinned);
                }

                return (void*)_pin.AddrOfPinnedObject();
            }
        }
    }

    /// <summary>Tells whether texels of a picture of a size are seldom in the processor's own cache.</summary>
    /// <param name="width">Number of columns.</param>
    /// <param name="height">Number of rows.</param>
    public static bool IsWorthCare(int width, int height) => (long)width * height > 1 << 16;

    /// <summary>The smaller versions of the picture, made once for every way to read it.</summary>
    /// <param name="key">What the way to read it depends on.</param>
    /// <param name="create">Makes them.</param>
    public MipPyramid Pyramid(object key, Func<MipPyramid> create)
    {
        lock (_pyramids)
        {
            if (!_pyramids.TryGetValue(key, out MipPyramid? pyramid))
            {
                pyramid = create();
                _pyramids[key] = pyramid;
            }

            return pyramid;
        }
    }

    /// <summary>The linear colour of one texel; y up.</summary>
    /// <param name="table">Linear light of every code, of the picture's format; not read for float samples.</param>
    /// <param name="x">Column, [0, width).</param>
    /// <param name="y">Row, up, [0, height).</param>
    public Intensity Color(ReadOnlySpan<float> table, int x, int y)
    {
        if (_pixels is not { } pixels)
        {
            byte* packed = Packed!.At(x, Height - 1 - y);
            return Decode(table, packed[0], packed[1], packed[2]);
        }

        int at = 4 * (Start - (y * Width) + x);
        return pixels.Format switch
        {
            PixelFormat.Rgba8 => Decode(table, pixels.Rgba8![at], pixels.Rgba8[at + 1], pixels.Rgba8[at + 2]),
            PixelFormat.Rgba16 => Decode(table, pixels.Rgba16![at], pixels.Rgba16[at + 1], pixels.Rgba16[at + 2]),
            _ => new Intensity(pixels.RgbaFloat![at], pixels.RgbaFloat[at + 1], pixels.RgbaFloat[at + 2]),
        };
    }

    /// <summary>Alpha of one texel, [0, 1]; y up.</summary>
    /// <param name="x">Column, [0, width).</param>
    /// <param name="y">Row, up, [0, height).</param>
    public float Alpha(int x, int y)
    {
        // Only opaque texels are packed.
        int at = (4 * (Start - (y * Width) + x)) + 3;
        return _pixels is not { } pixels ? 1 : pixels.Format switch
        {
            PixelFormat.Rgba8 => pixels.Rgba8![at] / 255f,
            PixelFormat.Rgba16 => pixels.Rgba16![at] / 65535f,
            _ => pixels.RgbaFloat![at],
        };
    }

    private static Intensity Decode(ReadOnlySpan<float> table, int r, int g, int b) => new(table[r], table[g], table[b]);
}
