using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The share that two strips have of texels together.</summary>
internal interface IEwaWeights
{
    /// <summary>The share of both.</summary>
    /// <param name="s">Shares of one strip.</param>
    /// <param name="t">Shares of the other one.</param>
    /// <param name="signs">Signs of the product of both coordinates.</param>
    /// <param name="skew">Correlation where the product is above 0.</param>
    static abstract Float8 Joint(Float8 s, Float8 t, Float8 signs, float skew);
}

/// <summary>Strips that cross at a wide angle: their shares are independent.</summary>
internal readonly struct Straight : IEwaWeights
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Joint(Float8 s, Float8 t, Float8 signs, float skew) => s * t;
}

/// <summary>Any strips: the product of the shares, corrected by the correlation, within Hoeffding's bounds.</summary>
internal readonly struct Skewed : IEwaWeights
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Float8 Joint(Float8 s, Float8 t, Float8 signs, float skew)
    {
        Float8 one = Float8.Of(1f), correlation = Float8.Of(skew) ^ (signs & Float8.Of(-0f));
        return Float8.Max(Float8.Min(Float8.Fma(correlation * (one - s), one - t, s * t), Float8.Min(s, t)), Float8.Zero);
    }
}
