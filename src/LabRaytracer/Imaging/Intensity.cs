using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A colour as linear RGB light (Polish: natężenie): three floats, never clamped.</summary>
/// <param name="R">Red, linear, 1 = display white; any value, also above 1.</param>
/// <param name="G">Green, linear.</param>
/// <param name="B">Blue, linear.</param>
/// <remarks>
/// Immutable, thread safe. Clamping belongs to <c>ToneMapping</c>, encoding to <c>ColorEncoding</c>: sums of lights stay right until then.
/// Named after the colour type of the lab sheet (Program 1).
/// </remarks>
public readonly record struct Intensity(float R, float G, float B)
{
    /// <summary>No light: (0, 0, 0).</summary>
    public static Intensity Black => default;

    /// <summary>Display white: (1, 1, 1).</summary>
    public static Intensity White => new(1, 1, 1);

    /// <summary>The largest component.</summary>
    public float Max => Math.Max(R, Math.Max(G, B));

    /// <summary>Relative luminance of linear Rec. 709 / sRGB primaries: 0.2126 R + 0.7152 G + 0.0722 B.</summary>
    public float Luminance => (0.2126f * R) + (0.7152f * G) + (0.0722f * B);

    /// <summary>Tells whether no component is NaN or infinite.</summary>
    public bool IsFinite => float.IsFinite(R) && float.IsFinite(G) && float.IsFinite(B);

    /// <summary>Grey of a given linear value.</summary>
    public static Intensity Grey(float value) => new(value, value, value);

    /// <summary>Sum of two colours (light adds).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Intensity operator +(Intensity a, Intensity b) => new(a.R + b.R, a.G + b.G, a.B + b.B);

    /// <summary>Difference of two colours, component by component; may be negative.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Intensity operator -(Intensity a, Intensity b) => new(a.R - b.R, a.G - b.G, a.B - b.B);

    /// <summary>Product component by component (a filter or a reflectance).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Intensity operator *(Intensity a, Intensity b) => new(a.R * b.R, a.G * b.G, a.B * b.B);

    /// <summary>The colour scaled by a factor.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Intensity operator *(Intensity a, float factor) => new(a.R * factor, a.G * factor, a.B * factor);

    /// <summary>The colour scaled by a factor.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Intensity operator *(float factor, Intensity a) => a * factor;

    /// <summary>Linear interpolation: <paramref name="a"/> at 0, <paramref name="b"/> at 1; the factor is not clamped.</summary>
    public static Intensity Lerp(Intensity a, Intensity b, float factor) => a + ((b - a) * factor);
}
