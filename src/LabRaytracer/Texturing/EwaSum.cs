using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A weighted sum of texels of one level, eight of a row at a time.</summary>
internal unsafe struct EwaSum
{
    private readonly MipPyramid _pyramid;
    private readonly TextureWrap _wrapU, _wrapV;
    private Float8 _red, _green, _blue, _weight;
    private int _row;
    private int _turn;

    /// <param name="pyramid">The levels.</param>
    /// <param name="level">The level, which is there.</param>
    /// <param name="wrapU">What lies beyond the columns.</param>
    /// <param name="wrapV">What lies beyond the rows.</param>
    public EwaSum(MipPyramid pyramid, int level, TextureWrap wrapU, TextureWrap wrapV)
    {
        _pyramid = pyramid;
        Level = level;
        _wrapU = wrapU;
        _wrapV = wrapV;
        Width = pyramid.Widths[level];
        Height = pyramid.Heights[level];
        _red = _green = _blue = _weight = Float8.Zero;
        _row = _turn = 0;
    }

    /// <summary>The level.</summary>
    public int Level { get; }

    /// <summary>Columns of the level.</summary>
    public int Width { get; }

    /// <summary>Rows of the level.</summary>
    public int Height { get; }

    /// <summary>The weighted mean so far.</summary>
    public readonly Intensity Mean
    {
        get
        {
            float toMean = 1 / Sum(_weight);
            return new Intensity(Sum(_red) * toMean, Sum(_green) * toMean, Sum(_blue) * toMean);
        }
    }

    /// <summary>Goes to a row.</summary>
    /// <param name="y">The row, anywhere.</param>
    /// <param name="start">Element number of the bottom-left texel of level 0, whose rows go up while the store's go down.</param>
    /// <param name="stride">Texels of a row of level 0.</param>
    public void StartRow(int y, int start, int stride)
    {
        bool isBeyond = (uint)y >= (uint)Height;
        _turn = isBeyond && _wrapV == TextureWrap.Pole ? Width / 2 : 0;
        int inside = isBeyond ? Wrap(y, Height, _wrapV) : y;
        _row = Level == 0 ? start - (inside * stride) : _pyramid.Starts[Level] + (inside * Width);
    }

    /// <summary>Adds eight texels of a level from 1 on.</summary>
    /// <param name="x">Column of the first one, anywhere.</param>
    /// <param name="weight">Their weights.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void AddLevel(int x, Float8 weight)
    {
        int first = Column(x);
        if (first <= Width - Float8.Width)
        {
            first += _row;
            Add(weight, *(Float8*)(_pyramid.Red + first), *(Float8*)(_pyramid.Green + first), *(Float8*)(_pyramid.Blue + first));
        }
        else
        {
            AddApart(x, weight);
        }
    }

    /// <summary>Adds eight texels of the picture.</summary>
    /// <param name="reader">Reads them.</param>
    /// <param name="x">Column of the first one, anywhere.</param>
    /// <param name="weight">Their weights.</param>
    public void AddPicture<TReader>(TReader reader, int x, Float8 weight)
        where TReader : struct, ITexelReader
    {
        int first = Column(x);
        Int8 texels = first <= Width - Float8.Width ? Int8.Iota(_row + first) : Apart(x);
        reader.Read(texels, out Float8 red, out Float8 green, out Float8 blue);
        Add(weight, red, green, blue);
    }

    /// <summary>A place beyond an end, brought inside.</summary>
    public static int Wrap(int place, int size, TextureWrap wrap)
    {
        switch (wrap)
        {
            case TextureWrap.Repeat:
                int rest = place % size;
                return rest < 0 ? rest + size : rest;
            case TextureWrap.Mirror:
                int twice = 2 * size, turn = ((place % twice) + twice) % twice;
                return turn < size ? turn : twice - 1 - turn;
            case TextureWrap.Pole:
                return Math.Clamp(place < 0 ? -1 - place : place < size ? place : (2 * size) - 1 - place, 0, size - 1);
            default:
                return Math.Clamp(place, 0, size - 1);
        }
    }

    /// <summary>Sum of eight numbers, always in the same order.</summary>
    private static float Sum(Float8 lanes)
    {
        float* n = (float*)&lanes;
        return ((n[0] + n[4]) + (n[2] + n[6])) + ((n[1] + n[5]) + (n[3] + n[7]));
    }

    /// <summary>The column of the first of eight texels if the other seven can follow it; else any that is too far to the right.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly int Column(int x)
    {
        x += _turn;
        return (uint)x < (uint)Width ? x : _wrapU == TextureWrap.Repeat ? Wrap(x, Width, TextureWrap.Repeat) : Width;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Add(Float8 weight, Float8 red, Float8 green, Float8 blue)
    {
        _weight += weight;
        _red = Float8.Fma(weight, red, _red);
        _green = Float8.Fma(weight, green, _green);
        _blue = Float8.Fma(weight, blue, _blue);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void AddApart(int x, Float8 weight)
    {
        Int8 texels = Apart(x);
        Add(weight, Float8.Gather((Float8*)_pyramid.Red, texels), Float8.Gather((Float8*)_pyramid.Green, texels), Float8.Gather((Float8*)_pyramid.Blue, texels));
    }

    /// <summary>Element numbers of eight texels, each wrapped by itself.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly Int8 Apart(int x)
    {
        int* texels = stackalloc int[Int8.Width];
        for (int k = 0; k < Int8.Width; k++)
        {
            texels[k] = _row + Wrap(x + _turn + k, Width, _wrapU);
        }

        return Int8.Load(texels);
    }
}
