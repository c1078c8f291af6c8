using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Blocks of texels of a large picture, which stays packed, anywhere.</summary>
/// <typeparam name="TReader">Reads the store's format.</typeparam>
/// <param name="texels">The picture.</param>
/// <param name="reader">Reads it.</param>
/// <param name="column">Column of the centre.</param>
/// <param name="row">Row of the centre.</param>
internal unsafe struct EwaPackedBlocks<TReader>(EwaLevel texels, TReader reader, int column, int row) : IEwaBlocks
    where TReader : struct, ITexelReader
{
    private int _lower, _upper, _lowerColumn, _upperColumn;

    public void Row(int y)
    {
        _lower = texels.Row(row + y, out int turn);
        _lowerColumn = column + turn;
        _upper = texels.Row(row + y + 1, out turn);
        _upperColumn = column + turn;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Add(int x, Float8 weights, ref Float8 sum, ref Float8 other)
    {
        Read(x, out Float8 lower0, out Float8 lower2, out Float8 upper0, out Float8 upper2);
        EwaColors.Add(weights, lower0, lower2, upper0, upper2, ref sum, ref other);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Total(Float8 sum, Float8 other) => EwaColors.Total(sum, other);

    [SkipLocalsInit]
    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly void Read(int x, out Float8 lower0, out Float8 lower2, out Float8 upper0, out Float8 upper2)
    {
        Float8* colors = stackalloc Float8[3];
        Float8* block = stackalloc Float8[4];
        reader.Read(texels.Eight(_lower, _lowerColumn + x, _upper, _upperColumn + x), out colors[0], out colors[1], out colors[2]);
        float* color = (float*)colors, texel = (float*)block;
        for (int k = 0; k < Float8.Width; k++)
        {
            (texel[0], texel[1], texel[2], texel[3]) = (color[k], color[Float8.Width + k], color[(2 * Float8.Width) + k], 1);
            texel += MipPyramid.Channels;
        }

        (lower0, lower2, upper0, upper2) = (block[0], block[1], block[2], block[3]);
    }
}
