using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>Smaller and smaller versions of a picture in linear light, each half as large as the one before (Williams, "Pyramidal parametrics", 1983).</summary>
/// <remarks>
/// <para>Level 0 is the picture itself and stays packed; of a small one there is an unpacked copy too, once somebody asks for it. Level k + 1 is made of level k by <see cref="MipReduction"/>, the first time that somebody asks for it;
/// a level has the same bits whoever builds it. 12 bytes a texel, a third of the picture's texels in all; memory of levels that nobody asks for is not touched.</para>
/// <para>Thread safe.</para>
/// </remarks>
internal sealed unsafe class MipPyramid
{
    /// <summary>Texels of a level from which several threads build it.</summary>
    private const int ParallelTexels = 1 << 14;

    /// <summary>Most texels of a picture that is unpacked: 12 megabytes.</summary>
    private const int UnpackedTexels = 1 << 20;

    private readonly TexelRows _picture;
    private readonly Lock _building = new();
    private readonly LaneMemory _memory = new();
    private readonly float* _block;
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
        HasPicture = (long)width * height <= UnpackedTexels;
        long texels = 0;
        for (int level = 0; level < count; level++)
        {
            Widths[level] = width;
            Heights[level] = height;
            Starts[level] = (int)texels;
            texels += level == 0 && !HasPicture ? 0 : (long)width * height;
            width = MipReduction.Half(width);
            height = MipReduction.Half(height);
        }

        if (texels > int.MaxValue)
        {
            throw new PictureFormatException("texture", $"a picture of {picture.Width} x {picture.Height} texels is too large for the filters trilinear, ewa and area, which take at most 6442450941 texels; use bilinear");
        }

        // Not cleared: pages that no level is written to take no memory.
        _block = (float*)NativeMemory.AlignedAlloc((nuint)((3 * Math.Max(1, texels)) + 16) * sizeof(float), 64);
        Red = _block;
        Green = _block + texels;
        Blue = Green + texels;
    }

    ~MipPyramid() => NativeMemory.AlignedFree(_block);

    /// <summary>Number of levels, with the picture itself; the last one is a single texel.</summary>
    public int LevelCount { get; }

    /// <summary>Columns of each level.</summary>
    public int* Widths { get; }

    /// <summary>Rows of each level.</summary>
    public int* Heights { get; }

    /// <summary>Tells whether the picture is small enough to be unpacked.</summary>
    public bool HasPicture { get; }

    /// <summary>
    /// Where each level starts in <see cref="Red"/>, <see cref="Green"/> and <see cref="Blue"/>: its bottom row first. Level 0 only if <see cref="HasPicture"/>.
    /// </summary>
    public int* Starts { get; }

    /// <summary>Red of all levels.</summary>
    public float* Red { get; }

    /// <summary>Green of all levels.</summary>
    public float* Green { get; }

    /// <summary>Blue of all levels.</summary>
    public float* Blue { get; }

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

    /// <summary>Unpacks the picture, which must be small enough.</summary>
    public void RequirePicture()
    {
        if (Volatile.Read(ref _isUnpacked))
        {
            return;
        }

        lock (_building)
        {
            for (int y = 0; !_isUnpacked && y < Heights[0]; y++)
            {
                long at = (long)y * Widths[0];
                _picture.Read(y, Red + at, Green + at, Blue + at);
            }

            Volatile.Write(ref _isUnpacked, true);
        }
    }

    /// <summary>One texel of a level from 1 on; y up.</summary>
    public Intensity Texel(int level, int x, int y)
    {
        int at = Starts[level] + (y * Widths[level]) + x;
        return new Intensity(Red[at], Green[at], Blue[at]);
    }

    private void Build(int level, int threads)
    {
        TexelRows source = level == 1 ? _picture : new LevelRows(this, level - 1);
        int height = Heights[level], start = Starts[level];
        bool isLarge = threads > 1 && (long)Widths[level] * height >= ParallelTexels;
        int parts = isLarge ? Math.Min(height, 8 * threads) : 1;
        void Part(int part) => MipReduction.Run(
            source, (int)((long)height * part / parts), (int)((long)height * (part + 1) / parts), Red + start, Green + start, Blue + start);
        if (parts == 1)
        {
            Part(0);
        }
        else
        {
            Parallel.For(0, parts, new ParallelOptions { MaxDegreeOfParallelism = threads }, Part);
        }
    }

    /// <summary>Rows of a level from 1 on.</summary>
    private sealed class LevelRows(MipPyramid pyramid, int level) : TexelRows
    {
        public override int Width => pyramid.Widths[level];

        public override int Height => pyramid.Heights[level];

        public override void Read(int y, float* red, float* green, float* blue)
        {
            long at = pyramid.Starts[level] + ((long)y * Width);
            new ReadOnlySpan<float>(pyramid.Red + at, Width).CopyTo(new Span<float>(red, Width));
            new ReadOnlySpan<float>(pyramid.Green + at, Width).CopyTo(new Span<float>(green, Width));
            new ReadOnlySpan<float>(pyramid.Blue + at, Width).CopyTo(new Span<float>(blue, Width));
        }
    }
}
