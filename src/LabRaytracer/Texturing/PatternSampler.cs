using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Looks up a computed pattern through a colour ramp, many points at a time.</summary>
/// <param name="pattern">The pattern.</param>
/// <param name="space">Where it lies.</param>
/// <param name="filterWidth">Width of the filter in footprints; 0 for none.</param>
/// <param name="ramp">Colours of its numbers.</param>
internal sealed unsafe class PatternSampler<TPattern>(TPattern pattern, PatternSpace space, double filterWidth, ColorRamp ramp) : TextureSampler
    where TPattern : struct, IPattern
{
    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        bool isFlat = space == PatternSpace.Uv;
        R* x = isFlat ? lookups.Coordinates.U : lookups.Positions.X, y = isFlat ? lookups.Coordinates.V : lookups.Positions.Y;
        for (int packet = 0; packet < packets; packet++)
        {
            F width = filterWidth > 0 ? FootprintWidth.Of<R, F>(lookups, space, packet) * F.Of(filterWidth) : F.Zero;
            PatternPoint<R, F> point = new(x[packet], y[packet], isFlat ? R.Zero : lookups.Positions.Z[packet], width, isFlat);
            F number = pattern.At<R, F, I>(point, out F kept);
            PatternColor.Of(ramp, number, kept, out colors.R[packet], out colors.G[packet], out colors.B[packet]);
        }
    }
}

/// <summary>Looks up a computed pattern at one point, with the same bits.</summary>
internal static class PatternSampler
{
    /// <summary>What a pattern reads of a hit.</summary>
    public static TextureNeeds Needs(PatternSpace space, double filterWidth) =>
        (space == PatternSpace.Uv ? TextureNeeds.Coordinate : TextureNeeds.LocalPoint) | (filterWidth > 0 ? TextureNeeds.Footprint : 0);

    /// <summary>The colour at a point.</summary>
    public static Intensity Sample<TPattern>(TPattern pattern, PatternSpace space, double filterWidth, ColorRamp ramp, in TextureLookup lookup)
        where TPattern : struct, IPattern
    {
        bool isFlat = space == PatternSpace.Uv;
        Float1 width = filterWidth > 0 ? FootprintWidth.Of(lookup, space) * Float1.Of(filterWidth) : Float1.Zero;
        PatternPoint<Double1, Float1> point = isFlat
            ? new(new(lookup.Coordinate.U), new(lookup.Coordinate.V), Double1.Zero, width, isFlat)
            : new(new(lookup.LocalPoint.X), new(lookup.LocalPoint.Y), new(lookup.LocalPoint.Z), width, isFlat);
        Float1 number = pattern.At<Double1, Float1, Int1>(point, out Float1 kept);
        PatternColor.Of(ramp, number, kept, out Float1 red, out Float1 green, out Float1 blue);
        return new Intensity(red.Value, green.Value, blue.Value);
    }
}

/// <summary>Colours of a pattern's numbers.</summary>
internal static class PatternColor
{
    /// <summary>The ramp's colours where the pattern is kept, its mean where it is not.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Of<F>(ColorRamp ramp, F number, F kept, out F red, out F green, out F blue)
        where F : unmanaged, IReal<F>
    {
        ramp.At(number, out red, out green, out blue);
        if (!F.All(F.LessOrEqual(F.Of(1), kept)))
        {
            Intensity mean = ramp.Mean;
            red = FilterFade.Mix(F.Of(mean.R), red, kept);
            green = FilterFade.Mix(F.Of(mean.G), green, kept);
            blue = FilterFade.Mix(F.Of(mean.B), blue, kept);
        }
    }
}
