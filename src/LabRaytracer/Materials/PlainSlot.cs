using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The usual forms of a colour slot, a constant or a constant times a looked-up colour, ready for a loop: <see cref="CompiledSlot.Read"/> with the same bits.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
internal readonly unsafe struct PlainSlot<F>
    where F : unmanaged, IReal<F>
{
    private readonly F _red, _green, _blue;
    private readonly ColorColumns<F> _texels;

    /// <param name="slot">A slot that <see cref="CompiledSlot.IsPlain"/>.</param>
    /// <param name="colors">Colours of all lookups of the material.</param>
    public PlainSlot(in CompiledSlot slot, ColorColumns<F>[] colors)
    {
        _red = F.Of(slot.Value.R);
        _green = F.Of(slot.Value.G);
        _blue = F.Of(slot.Value.B);
        _texels = slot.Lookup >= 0 ? colors[slot.Lookup] : default;
    }

    /// <summary>The coefficient of one group of lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Read(int packet, out F red, out F green, out F blue)
    {
        red = _red;
        green = _green;
        blue = _blue;
        if (_texels.R != null)
        {
            red *= _texels.R[packet];
            green *= _texels.G[packet];
            blue *= _texels.B[packet];
        }
    }
}
