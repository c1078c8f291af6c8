using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Blocks of texels of an unpacked level, anywhere.</summary>
/// <param name="texels">The level.</param>
/// <param name="pyramid">Its texels.</param>
/// <param name="column">Column of the centre.</param>
/// <param name="row">Row of the centre.</param>
internal unsafe struct EwaOuterBlocks(EwaLevel texels, MipPyramid pyramid, int column, int row) : IEwaBlocks
{
    private readonly float* _texels = pyramid.Texels;
    private readonly uint _places = (uint)Math.Max(texels.Width - 3, 0);
    private float* _lower, _upper;
    private int _lowerColumn, _upperColumn;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Row(int y)
    {
        _lower = _texels + (MipPyramid.Channels * (nint)texels.Row(row + y, out int turn));
        _lowerColumn = column + turn;
        _upper = _texels + (MipPyramid.Channels * (nint)texels.Row(row + y + 1, out turn));
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

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private readonly void Read(int x, out Float8 lower0, out Float8 lower2, out Float8 upper0, out Float8 upper2)
    {
        int lowerColumn = texels.Column(_lowerColumn + x), upperColumn = texels.Column(_upperColumn + x);
        if ((uint)lowerColumn < _places && (uint)upperColumn < _places)
        {
            Float8* lower = (Float8*)(_lower + (MipPyramid.Channels * lowerColumn)), upper = (Float8*)(_upper + (MipPyramid.Channels * upperColumn));
            lower0 = lower[0];
            lower2 = lower[1];
            upper0 = upper[0];
            upper2 = upper[1];
            return;
        }

        ReadApart(x, out lower0, out lower2, out upper0, out upper2);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private readonly void ReadApart(int x, out Float8 lower0, out Float8 lower2, out Float8 upper0, out Float8 upper2)
    {
        lower0 = Float8.Join(At(_lower, _lowerColumn + x), At(_lower, _lowerColumn + x + 1));
        lower2 = Float8.Join(At(_lower, _lowerColumn + x + 2), At(_lower, _lowerColumn + x + 3));
        upper0 = Float8.Join(At(_upper, _upperColumn + x), At(_upper, _upperColumn + x + 1));
        upper2 = Float8.Join(At(_upper, _upperColumn + x + 2), At(_upper, _upperColumn + x + 3));
    }

    private readonly Float4 At(float* row, int x) => Float4.Load(row + (MipPyramid.Channels * texels.Inside(x)));
}
