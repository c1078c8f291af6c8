using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Blocks of texels of an unpacked level that lie inside of it.</summary>
/// <param name="center">The texel of the centre.</param>
/// <param name="stride">Floats from a row to the next one.</param>
internal unsafe struct EwaInnerBlocks(float* center, nint stride) : IEwaBlocks
{
    private float* _row;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Row(int y) => _row = center + (y * stride);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Read(int x, out Float8 lower0, out Float8 lower2, out Float8 upper0, out Float8 upper2)
    {
        Float8* lower = (Float8*)(_row + (MipPyramid.Channels * x)), upper = (Float8*)((float*)lower + stride);
        lower0 = lower[0];
        lower2 = lower[1];
        upper0 = upper[0];
        upper2 = upper[1];
    }
}
