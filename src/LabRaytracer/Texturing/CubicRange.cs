using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Colours of several points.</summary>
internal struct CubicColor<F>
    where F : unmanaged, IReal<F>
{
    public F R, G, B;
}

/// <summary>The least and the largest of several colours, component by component.</summary>
internal struct CubicRange<F>
    where F : unmanaged, IReal<F>
{
    private CubicColor<F> _low, _high;

    /// <summary>The range of no colours.</summary>
    public static CubicRange<F> Empty
    {
        get
        {
            F low = F.Of(double.PositiveInfinity), high = F.Of(double.NegativeInfinity);
            return new CubicRange<F> { _low = new CubicColor<F> { R = low, G = low, B = low }, _high = new CubicColor<F> { R = high, G = high, B = high } };
        }
    }

    /// <summary>Widens the range to a colour.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(in CubicColor<F> color)
    {
        _low.R = F.Min(_low.R, color.R);
        _low.G = F.Min(_low.G, color.G);
        _low.B = F.Min(_low.B, color.B);
        _high.R = F.Max(_high.R, color.R);
        _high.G = F.Max(_high.G, color.G);
        _high.B = F.Max(_high.B, color.B);
    }

    /// <summary>Brings a colour into the range; NaN stays.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Clamp(ref CubicColor<F> color)
    {
        color.R = F.Max(_low.R, F.Min(_high.R, color.R));
        color.G = F.Max(_low.G, F.Min(_high.G, color.G));
        color.B = F.Max(_low.B, F.Min(_high.B, color.B));
    }
}
