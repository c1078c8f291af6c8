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
    public readonly void Add(int x, Float8 weights, ref Float8 sum, ref Float8 other)
    {
        Float8* lower = (Float8*)(_row + (MipPyramid.Channels * x)), upper = (Float8*)((float*)lower + stride);
        EwaColors.Add(weights, lower[0], lower[1], upper[0], upper[1], ref sum, ref other);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Total(Float8 sum, Float8 other) => EwaColors.Total(sum, other);
}
