using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The four texels along one axis that a cubic kernel reads, and their weights.</summary>
/// <remarks>
/// The weight of the second texel is what the others leave of 1, so it is not stored: a mean is formed from differences to that texel, and a constant picture
/// stays constant to the last bit.
/// </remarks>
internal struct CubicTaps<F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Numbers of the texels; the coordinate lies between the second and the third.</summary>
    public I Texel0, Texel1, Texel2, Texel3;

    /// <summary>Weights of all but the second.</summary>
    public F Weight0, Weight2, Weight3;

    /// <summary>Sets the weights of a point that lies a share of the way from the second texel to the third.</summary>
    /// <param name="filter">Catmull-Rom or B-spline.</param>
    /// <param name="share">The share, [0, 1).</param>
    /// <remarks>
    /// The family of Mitchell and Netravali, "Reconstruction Filters in Computer Graphics" (1988), equation 8: Catmull-Rom is B = 0, C = 1/2, the B-spline B = 1, C = 0.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Weigh(TextureFilter filter, F share)
    {
        F one = F.Of(1), rest = one - share;
        if (filter == TextureFilter.CatmullRom)
        {
            F product = share * rest * F.Of(-0.5);
            Weight0 = product * rest;
            Weight2 = share * F.Fma(share, F.Fma(share, F.Of(-1.5), F.Of(2)), F.Of(0.5));
            Weight3 = product * share;
            return;
        }

        F sixth = F.Of(1.0 / 6);
        Weight0 = rest * rest * rest * sixth;
        Weight2 = F.Fma(share, F.Fma(share, F.Fma(share, F.Of(-3), F.Of(3)), F.Of(3)), one) * sixth;
        Weight3 = share * share * share * sixth;
    }

    /// <summary>The weighted mean of four numbers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly F Mean(F value0, F value1, F value2, F value3) =>
        F.Fma(Weight3, value3 - value1, F.Fma(Weight2, value2 - value1, F.Fma(Weight0, value0 - value1, value1)));
}
