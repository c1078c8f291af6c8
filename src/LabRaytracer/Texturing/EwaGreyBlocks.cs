using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Blocks of texels of a grey level that lie inside of it.</summary>
/// <param name="center">The texel of the centre.</param>
/// <param name="stride">From a row to the next one.</param>
internal unsafe struct EwaGreyBlocks(float* center, nint stride) : IEwaBlocks
{
    private float* _row;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Row(int y) => _row = center + (y * stride);

    /// <summary>Adds to the sum of the texels, and to that of the weights.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Add(int x, Float8 weights, ref Float8 sum, ref Float8 other)
    {
        float* lower = _row + x;
        sum = Float8.Fma(weights, Float8.Join(Float4.Load(lower), Float4.Load(lower + stride)), sum);
        other += weights;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float4 Total(Float8 sum, Float8 other) => Float8.SumsOfLanes(sum, other);
}
