using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The texels of one level of a pyramid, anywhere: beyond the edges lies what the wraps put there.</summary>
internal readonly unsafe struct EwaLevel
{
    private readonly TextureWrap _wrapU, _wrapV;
    private readonly int _start, _stride;

    /// <param name="pyramid">The levels.</param>
    /// <param name="level">The level, which is there.</param>
    /// <param name="pictureStart">Element number of the bottom-left texel of a picture that stays packed, whose rows go up while the store's go down.</param>
    /// <param name="wrapU">What lies beyond the columns.</param>
    /// <param name="wrapV">What lies beyond the rows.</param>
    public EwaLevel(MipPyramid pyramid, int level, int pictureStart, TextureWrap wrapU, TextureWrap wrapV)
    {
        _wrapU = wrapU;
        _wrapV = wrapV;
        Width = pyramid.Widths[level];
        Height = pyramid.Heights[level];
        bool isPacked = level == 0 && !pyramid.HasPicture;
        _start = isPacked ? pictureStart : pyramid.Starts[level];
        _stride = isPacked ? -Width : pyramid.Strides[level];
    }

    /// <summary>Columns of the level.</summary>
    public int Width { get; }

    /// <summary>Rows of the level.</summary>
    public int Height { get; }

    /// <summary>A place beyond an end, brought inside.</summary>
    /// <param name="place">Column or row, anywhere.</param>
    /// <param name="size">Number of columns or rows.</param>
    /// <param name="wrap">What lies beyond.</param>
    public static int Wrap(int place, int size, TextureWrap wrap)
    {
        if ((uint)place < (uint)size)
        {
            return place;
        }

        switch (wrap)
        {
            case TextureWrap.Repeat:
                int rest = place % size;
                return rest < 0 ? rest + size : rest;
            case TextureWrap.Mirror:
                int twice = 2 * size, turn = ((place % twice) + twice) % twice;
                return turn < size ? turn : twice - 1 - turn;
            case TextureWrap.Pole:
                return Math.Clamp(place < 0 ? -1 - place : (2 * size) - 1 - place, 0, size - 1);
            default:
                return Math.Clamp(place, 0, size - 1);
        }
    }

    /// <summary>Element number of the first texel of a row.</summary>
    /// <param name="y">The row, anywhere.</param>
    /// <param name="turn">How many columns further the row is read: half of them beyond a pole.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Row(int y, out int turn)
    {
        turn = 0;
        if ((uint)y >= (uint)Height)
        {
            turn = _wrapV == TextureWrap.Pole ? Width / 2 : 0;
            y = Wrap(y, Height, _wrapV);
        }

        return _start + (y * _stride);
    }

    /// <summary>A column brought inside where that is done in one step: the others are left as they are.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int Column(int x) => (uint)x < (uint)Width || _wrapU != TextureWrap.Repeat ? x : Wrap(x, Width, TextureWrap.Repeat);

    /// <summary>A column brought inside.</summary>
    public int Inside(int x) => Wrap(x, Width, _wrapU);

    /// <summary>Element numbers of four texels of one row and four of another.</summary>
    /// <param name="lower">Element number of the first texel of the first row.</param>
    /// <param name="lowerX">Column in it, anywhere.</param>
    /// <param name="upper">Element number of the first texel of the second row.</param>
    /// <param name="upperX">Column in it, anywhere.</param>
    public Int8 Eight(int lower, int lowerX, int upper, int upperX)
    {
        int* elements = stackalloc int[Int8.Width];
        for (int k = 0; k < 4; k++)
        {
            elements[k] = lower + Wrap(lowerX + k, Width, _wrapU);
            elements[k + 4] = upper + Wrap(upperX + k, Width, _wrapU);
        }

        return Int8.Load(elements);
    }
}
