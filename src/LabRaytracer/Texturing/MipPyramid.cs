using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>Smaller and smaller versions of a picture in linear light, each half as large as the one before (Williams, "Pyramidal parametrics", 1983).</summary>
/// <remarks>
/// <para>Level 0 is the picture itself and stays packed; of a small one there is an unpacked copy too, once somebody asks for it. Level k + 1 is made of level k by <see cref="MipReduction"/>, the first time that somebody asks for it;
/// a level has the same bits whoever builds it. 16 bytes a texel, a third of the picture's texels in all; each row ends with its first texel once more, for those who read two at a time where the picture repeats; memory of levels that nobody asks for is not touched.</para>
/// <para>Thread safe.</para>
/// </remarks>
internal sealed unsafe class MipPyramid
{
    /// <summary>Texels of a level from which several threads build it.</summary>
    private const int ParallelTexels = 1 << 14;

    /// <summary>Most texels of a picture that is unpacked: 16 megabytes.</summary>
    private const int UnpackedTexels = 1 << 20;

    /// <summary>Floats of a texel: red, green, blue, 1.</summary>
    public const int Channels = 4;

    /// <summary>Texels in a line of the cache.</summary>
    private const int LineTexels = 4;

    /// <summary>Texels from which on a row counts as long.</summary>
    private const int LongRow = 128;

    private readonly TexelRows _picture;
    private readonly Lock _building = new();
    private readonly LaneMemory _memory = new();
    private int _built;
    private bool _isUnpacked;

    /// <param name="picture">The picture, linear light.</param>
    public MipPyramid(TexelRows picture)
    {
        _picture = picture;
        int width = picture.Width, height = picture.Height, count = 1;
        for (int longest = Math.Max(width, height); longest > 1; longest /= 2)
        {
            count++;
        }

        LevelCount = count;
        Widths = _memory.Column<int>(count, 1);
        Heights = _memory.Column<int>(count, 1);
        Starts = _memory.Column<int>(count, 1);
        Strides = _memory.Column<int>(count, 1);
        HasPicture = (long)width * height <= UnpackedTexels;
        long texels = 0;
        for (int level = 0; level < count; level++)
        {
            Widths[level] = width;
            Heights[level] = height;
            Starts[level] = (int)texels;
            Strides[level] = Stride(width);
            texels += level == 0 && !HasPicture ? 0 : (long)Strides[level] * height;
            width = MipReduction.Half(width);
            height = MipReduction.Half(height);
        }

        if (texels > int.MaxValue / Channels)
        {
            throw new PictureFormatException("texture", $"a picture of {picture.Width} x {picture.Height} texels is too large for the filters trilinear, ewa and area, which take at most 1600000000 texels; use bilinear");
        }

        // Not cleared: pages that no level is written to take no memory.
        Texels = (float*)NativeMemory.AlignedAlloc((nuint)(Channels * Math.Max(1, texels)) * sizeof(float), 64);
    }

    ~MipPyramid() => NativeMemory.AlignedFree(Texels);

    /// <summary>Number of levels, with the picture itself; the last one is a single texel.</summary>
    public int LevelCount { get; }

    /// <summary>Columns of each level.</summary>
    public int* Widths { get; }

    /// <summary>Rows of each level.</summary>
    public int* Heights { get; }

    /// <summary>Tells whether the picture is small enough to be unpacked.</summary>
    public bool HasPicture { get; }

    /// <summary>The texel of <see cref="Texels"/> at which each level starts: its bottom row first. Level 0 only if <see cref="HasPicture"/>.</summary>
    public int* Starts { get; }

    /// <summary>From the first texel of a row to that of the next one.</summary>
    public int* Strides { get; }

    /// <summary>
    /// The texels of all levels: red, green, blue and 1, side by side, so that a texel lies in one line of the cache and a weighted sum of texels adds up the weights too.
    /// </summary>
    public float* Texels { get; }

    /// <summary>Number of the highest level that is there.</summary>
    public int Built => Volatile.Read(ref _built);

    /// <summary>Makes sure that a level and those below it are there.</summary>
    /// <param name="level">The level, [0, <see cref="LevelCount"/>).</param>
    /// <param name="threads">Threads that may build it, at least 1.</param>
    public void Require(int level, int threads)
    {
        if (level <= Built)
        {
            return;
        }

        lock (_building)
        {
            while (_built < level)
            {
                Build(_built + 1, threads);
                Volatile.Write(ref _built, _built + 1);
            }
        }
    }

    /// <summary>
    /// Texels of a row, its first one again, and, where rows are long, some that nobody reads: an odd number of lines of the cache. Rows at distances of powers of two compete for the same few
    /// places in it, and footprints that reach over many rows then wait for the memory at each of them.
    /// </summary>
    private static int Stride(int width) => width < LongRow ? width + 1 : (((width / LineTexels) + 1) | 1) * LineTexels;

    /// <summary>Unpacks the picture, which must be small enough.</summary>
    public void RequirePicture()
    {
        if (Volatile.Read(ref _isUnpacked))
        {
            return;
        }

        lock (_building)
        {
            if (!_isUnpacked)
            {
                Unpack();
            }

            Volatile.Write(ref _isUnpacked, true);
        }
    }

    private void Unpack()
    {
        using LaneMemory memory = new();
        int width = Widths[0];
        float* row = memory.Column<float>((3 * width) + 48, 1);
        for (int y = 0; y < Heights[0]; y++)
        {
            _picture.Read(y, row, row + width, row + (2 * width));
            float* texel = Texels + ((long)y * Strides[0] * Channels);
            for (int x = 0; x < width; x++)
            {
                (texel[0], texel[1], texel[2], texel[3]) = (row[x], row[width + x], row[(2 * width) + x], 1);
                texel += Channels;
            }

            Close(0, y, y + 1);
        }
    }

    /// <summary>Writes the first texel of some rows behind the last one: what lies there where the picture repeats, and nothing at all elsewhere.</summary>
    private void Close(int level, int first, int end)
    {
        for (int y = first; y < end; y++)
        {
            float* row = Texels + (Channels * (Starts[level] + ((long)y * Strides[level])));
            new ReadOnlySpan<float>(row, Channels).CopyTo(new Span<float>(row + (Channels * Widths[level]), Channels));
        }
    }

    /// <summary>One texel of a level from 1 on; y up.</summary>
    public Intensity Texel(int level, int x, int y)
    {
        float* texel = Texels + (Channels * (long)(Starts[level] + (y * Strides[level]) + x));
        return new Intensity(texel[0], texel[1], texel[2]);
    }

    private void Build(int level, int threads)
    {
        TexelRows source = level == 1 && !_isUnpacked ? _picture : new LevelRows(this, level - 1);
        int height = Heights[level];
        float* texels = Texels + (Channels * (long)Starts[level]);
        bool isLarge = threads > 1 && (long)Widths[level] * height >= ParallelTexels;
        int parts = isLarge ? Math.Min(height, 8 * threads) : 1;
        void Part(int part)
        {
            int first = (int)((long)height * part / parts), end = (int)((long)height * (part + 1) / parts);
            MipReduction.Run(source, first, end, Channels * Strides[level], texels);
            Close(level, first, end);
        }

        if (parts == 1)
        {
            Part(0);
        }
        else
        {
            Parallel.For(0, parts, new ParallelOptions { MaxDegreeOfParallelism = threads }, Part);
        }
    }

    /// <summary>Rows of a level that is unpacked.</summary>
    private sealed class LevelRows(MipPyramid pyramid, int level) : TexelRows
    {
        public override int Width => pyramid.Widths[level];

        public override int Height => pyramid.Heights[level];

        public override void Read(int y, float* red, float* green, float* blue)
        {
            float* texel = pyramid.Texels + (Channels * (pyramid.Starts[level] + ((long)y * pyramid.Strides[level])));
            for (int x = 0; x < Width; x++)
            {
                (red[x], green[x], blue[x]) = (texel[0], texel[1], texel[2]);
                texel += Channels;
            }
        }
    }
}
