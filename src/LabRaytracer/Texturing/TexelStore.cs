using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>The packed texels of a texture, in the file's own format and row order (row 0 on top), pinned for gathers.</summary>
/// <remarks>Immutable but for the smaller versions that it keeps, thread safe.</remarks>
internal sealed unsafe class TexelStore
{
    private readonly GCHandle _pin;
    private readonly Dictionary<object, MipPyramid> _pyramids = [];

    public TexelStore(PixelBuffer pixels)
    {
        Pixels = pixels;
        _pin = GCHandle.Alloc((Array?)pixels.Rgba8 ?? (Array?)pixels.Rgba16 ?? pixels.RgbaFloat, GCHandleType.Pinned);
    }

    ~TexelStore() => _pin.Free();

    /// <summary>The picture.</summary>
    public PixelBuffer Pixels { get; }

    /// <summary>Number of columns.</summary>
    public int Width => Pixels.Width;

    /// <summary>Number of rows.</summary>
    public int Height => Pixels.Height;

    /// <summary>Element number of texel (0, 0), the bottom-left one: rows go up, so the stride is minus the width.</summary>
    public int Start => (Height - 1) * Width;

    /// <summary>Tells whether texels are seldom in the processor's own cache.</summary>
    public bool IsLarge => (long)Width * Height > 1 << 16;

    /// <summary>The first sample of the top-left texel.</summary>
    public void* Samples => (void*)_pin.AddrOfPinnedObject();

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
        int at = 4 * (Start - (y * Width) + x);
        return Pixels.Format switch
        {
            PixelFormat.Rgba8 => Decode(table, Pixels.Rgba8![at], Pixels.Rgba8[at + 1], Pixels.Rgba8[at + 2]),
            PixelFormat.Rgba16 => Decode(table, Pixels.Rgba16![at], Pixels.Rgba16[at + 1], Pixels.Rgba16[at + 2]),
            _ => new Intensity(Pixels.RgbaFloat![at], Pixels.RgbaFloat[at + 1], Pixels.RgbaFloat[at + 2]),
        };
    }

    /// <summary>Alpha of one texel, [0, 1]; y up.</summary>
    /// <param name="x">Column, [0, width).</param>
    /// <param name="y">Row, up, [0, height).</param>
    public float Alpha(int x, int y)
    {
        int at = (4 * (Start - (y * Width) + x)) + 3;
        return Pixels.Format switch
        {
            PixelFormat.Rgba8 => Pixels.Rgba8![at] / 255f,
            PixelFormat.Rgba16 => Pixels.Rgba16![at] / 65535f,
            _ => Pixels.RgbaFloat![at],
        };
    }

    private static Intensity Decode(ReadOnlySpan<float> table, int r, int g, int b) => new(table[r], table[g], table[b]);
}
