using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A scalar slot made ready: a constant, or a number blended with one channel of a looked-up colour.</summary>
/// <param name="Slot">The slot; its texture is constant-folded into <paramref name="Value"/> where it can be.</param>
/// <param name="Value">The number without texture, or the constant result.</param>
/// <param name="Lookup">Number of the lookup, or -1 for a constant.</param>
internal readonly record struct CompiledScalar(ScalarSlot Slot, float Value, int Lookup)
{
    /// <summary>The number of one group of lanes: <see cref="ScalarSlot.Apply"/> with the same bits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public unsafe F Read<F>(ColorColumns<F>[] colors, int packet)
        where F : unmanaged, IReal<F>
    {
        F value = F.Of(Value);
        if (Lookup < 0)
        {
            return value;
        }

        ColorColumns<F> texels = colors[Lookup];
        F texel = Slot.Channel switch
        {
            TextureChannel.Red or TextureChannel.Alpha => texels.R[packet],
            TextureChannel.Green => texels.G[packet],
            TextureChannel.Blue => texels.B[packet],
            _ => (F.Of(0.2126f) * texels.R[packet]) + (F.Of(0.7152f) * texels.G[packet]) + (F.Of(0.0722f) * texels.B[packet]),
        };
        F blended = Slot.Blend switch
        {
            BlendMode.Multiply => value * texel,
            BlendMode.Replace => texel,
            BlendMode.Add => value + texel,
            _ => value + ((texel - value) * F.Of(0.5)),
        };
        return Slot.Amount == 1 ? blended : value + ((blended - value) * F.Of(Slot.Amount));
    }
}
