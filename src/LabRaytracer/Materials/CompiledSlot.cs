using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A colour slot made ready: a constant, or a value blended with a looked-up colour.</summary>
/// <param name="Value">The coefficient without texture, or the constant result.</param>
/// <param name="Lookup">Number of the lookup whose colour is blended in, or -1 for a constant.</param>
/// <param name="Blend">How.</param>
/// <param name="Amount">How much, [0, 1].</param>
internal readonly record struct CompiledSlot(Intensity Value, int Lookup, BlendMode Blend, float Amount)
{
    /// <summary>Tells whether the coefficient is zero everywhere: whatever it multiplies is not computed.</summary>
    public bool IsBlack => Lookup < 0 && Value == Intensity.Black;

    /// <summary>Tells whether the coefficient is a constant, or a constant times the looked-up colour.</summary>
    public bool IsPlain => Lookup < 0 || (Blend == BlendMode.Multiply && Amount == 1);

    /// <summary>The coefficient of one group of lanes: <see cref="TextureSlot.Apply"/> with the same bits.</summary>
    /// <param name="colors">Colours of all lookups of the material.</param>
    /// <param name="packet">Group of lanes.</param>
    /// <param name="red">Red.</param>
    /// <param name="green">Green.</param>
    /// <param name="blue">Blue.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public unsafe void Read<F>(ColorColumns<F>[] colors, int packet, out F red, out F green, out F blue)
        where F : unmanaged, IReal<F>
    {
        red = F.Of(Value.R);
        green = F.Of(Value.G);
        blue = F.Of(Value.B);
        if (Lookup >= 0)
        {
            ColorColumns<F> texels = colors[Lookup];
            red = Apply(red, texels.R[packet]);
            green = Apply(green, texels.G[packet]);
            blue = Apply(blue, texels.B[packet]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private F Apply<F>(F value, F texel)
        where F : unmanaged, IReal<F>
    {
        F blended = Blend switch
        {
            BlendMode.Multiply => value * texel,
            BlendMode.Replace => texel,
            BlendMode.Add => value + texel,
            _ => value + ((texel - value) * F.Of(0.5)),
        };
        return Amount == 1 ? blended : value + ((blended - value) * F.Of(Amount));
    }
}
