using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>Smaller and smaller versions of a picture in linear light, each half as large as the one before (Williams, "Pyramidal parametrics", 1983).</summary>
/// <remarks>
/// <para>Level 0 is the picture itself and stays packed; of a small one there is an unpacked copy too, once somebody asks for it. Level k + 1 is made of level k by <see cref="MipReduction"/>, the first time that somebody asks for it;
/// a level has the same bits whoever builds it. 16 bytes a texel, a third of the picture's texels in all; behind each row lies its first texel once more, for those who read two at a time where the picture repeats; memory of levels that nobody asks for is not touched.</para>
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
    /// <param name="margin">Texels around each level that show it once more, as a wall of tiles would: what repeats is then read without looking where it ends. A multiple of 4.</param>
    public MipPyramid(TexelRows picture, int margin = 0)
    {
        _picture = picture;
        Margin = margin;
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
            Strides[level] = Stride(margin + width + Math.Max(margin, 1));
            Starts[level] = (int)Math.Min(texels + ((long)margin * Strides[level]) + margin, int.MaxValue);
            texels += level == 0 && !HasPicture ? 0 : (long)Strides[level] * (height + (2 * margin));
            width = MipReduction.Half(width);
            height = MipReduction.Half(height);
        }

        if (texels > int.MaxValue / Channels)
        {
            throw new PictureFormatException("texture", $"a picture of {picture.Width} x {picture.Height} texels is too large for the filters trilinear, ewa and area, which take at most 1600000000 texels; use bilinear");
        }

        // Not cleared: pages that no level is written to take no memory.
        Texels = (float*)NativeMemory.AlignedAlloc((nuint)(Channels * Math.Max(1, texels)) * sizeof(float), 64);
        Grey = new GreyLevels(this, texels);
    }

    ~MipPyramid() => NativeMemory.AlignedFree(Texels);

    /// <summary>Number of levels, with the picture itself; the last one is a single texel.</summary>
    public int LevelCount { get; }

    /// <summary>Texels around each level that show it once more; of those beside it, one on the right is always there.</summary>
    public int Margin { get; }

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

    /// <summary>Levels that are grey once more, a number a texel.</summary>
    public GreyLevels Grey { get; }

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
    /// Texels of a row with those beside it and, where rows are long, some that nobody reads: an odd number of lines of the cache. Rows at distances of powers of two compete for the same few
    /// places in it, and footprints that reach over many rows then wait for the memory at each of them.
    /// </summary>
    private static int Stride(int width) => width < LongRow ? width : (((width + LineTexels - 1) / LineTexels) | 1) * LineTexels;

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
            float* texel = Row(0, y);
            for (int x = 0; x < width; x++)
            {
                (texel[0], texel[1], texel[2], texel[3]) = (row[x], row[width + x], row[(2 * width) + x], 1);
                texel += Channels;
            }
        }

        CloseRows(0, 0, Heights[0]);
        Close(0);
    }

    /// <summary>Writes what lies beside some rows of a level.</summary>
    private void CloseRows(int level, int first, int end)
    {
        int width = Widths[level];
        for (int y = first; y < end; y++)
        {
            float* row = Row(level, y);
            for (int x = -Margin; x < width + Math.Max(Margin, 1); x = x == -1 ? width : x + 1)
            {
                int inside = x % width;
                float* from = row + (Channels * (inside < 0 ? inside + width : inside)), to = row + (Channels * x);
                (to[0], to[1], to[2], to[3]) = (from[0], from[1], from[2], from[3]);
            }
        }
    }

    /// <summary>Writes what lies below and above a level, whose rows are closed.</summary>
    private void Close(int level)
    {
        int height = Heights[level], floats = Channels * (Widths[level] + (2 * Margin));
        for (int y = -Margin; y < height + Margin; y = y == -1 ? height : y + 1)
        {
            int inside = y % height;
            new ReadOnlySpan<float>(Row(level, inside < 0 ? inside + height : inside) - (Channels * Margin), floats).CopyTo(new Span<float>(Row(level, y) - (Channels * Margin), floats));
        }
    }

    private float* Row(int level, int y) => Texels + (Channels * (Starts[level] + ((long)y * Strides[level])));

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
            CloseRows(level, first, end);
        }

        if (parts == 1)
        {
            Part(0);
        }
        else
        {
            Parallel.For(0, parts, new ParallelOptions { MaxDegreeOfParallelism = threads }, Part);
        }

        Close(level);
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
