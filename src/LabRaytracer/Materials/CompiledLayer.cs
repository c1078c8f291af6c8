using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A layer made ready.</summary>
/// <param name="Lookup">Number of the lookup of its colour times alpha, or -1 for a constant.</param>
/// <param name="AlphaLookup">Number of the lookup of its alpha, or -1 for a constant.</param>
/// <param name="Coordinates">Number of the coordinate set outside of whose unit square nothing is there, or -1.</param>
/// <param name="Color">The constant colour times alpha.</param>
/// <param name="Alpha">The constant alpha.</param>
/// <param name="Blend">What becomes of the value below.</param>
/// <param name="Opacity">Factor of alpha, (0, 1].</param>
internal readonly record struct CompiledLayer(int Lookup, int AlphaLookup, int Coordinates, Intensity Color, float Alpha, BlendMode Blend, float Opacity)
{
    /// <summary>The value above the layer: below + opacity (blend(below, colour) - below) alpha.</summary>
    /// <param name="below">The value below.</param>
    /// <param name="color">Colour times alpha.</param>
    /// <param name="alpha">Alpha.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public F Apply<F>(F below, F color, F alpha)
        where F : unmanaged, IReal<F>
    {
        F change = Blend switch
        {
            BlendMode.Multiply => below * (color - alpha),
            BlendMode.Add => color,
            BlendMode.Mix => (color - (alpha * below)) * F.Of(0.5),
            _ => color - (alpha * below),
        };
        return Opacity == 1 ? below + change : below + (change * F.Of(Opacity));
    }
}
