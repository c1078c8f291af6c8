namespace LabRaytracer;

/// <summary>Looks up a computed pattern through a colour ramp, many points at a time.</summary>
internal sealed unsafe class PatternSampler<TPattern>(TPattern pattern, PatternSpace space, ColorRamp ramp) : TextureSampler
    where TPattern : struct, IPattern
{
    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        bool isFlat = space == PatternSpace.Uv;
        R* x = isFlat ? lookups.Coordinates.U : lookups.Positions.X, y = isFlat ? lookups.Coordinates.V : lookups.Positions.Y;
        for (int packet = 0; packet < packets; packet++)
        {
            PatternPoint<R, F> point = new(x[packet], y[packet], isFlat ? R.Zero : lookups.Positions.Z[packet], F.Zero, isFlat);
            ramp.At(pattern.At<R, F, I>(point), out colors.R[packet], out colors.G[packet], out colors.B[packet]);
        }
    }
}

/// <summary>Looks up a computed pattern at one point, with the same bits.</summary>
internal static class PatternSampler
{
    /// <summary>What a pattern reads of a hit.</summary>
    public static TextureNeeds Needs(PatternSpace space) => space == PatternSpace.Uv ? TextureNeeds.Coordinate : TextureNeeds.LocalPoint;

    /// <summary>The colour at a point.</summary>
    public static Intensity Sample<TPattern>(TPattern pattern, PatternSpace space, ColorRamp ramp, in TextureLookup lookup)
        where TPattern : struct, IPattern => ramp.At(Number(pattern, space, lookup));

    /// <summary>The number at a point.</summary>
    public static float Number<TPattern>(TPattern pattern, PatternSpace space, in TextureLookup lookup)
        where TPattern : struct, IPattern
    {
        bool isFlat = space == PatternSpace.Uv;
        PatternPoint<Double1, Float1> point = isFlat
            ? new(new(lookup.Coordinate.U), new(lookup.Coordinate.V), Double1.Zero, Float1.Zero, isFlat)
            : new(new(lookup.LocalPoint.X), new(lookup.LocalPoint.Y), new(lookup.LocalPoint.Z), Float1.Zero, isFlat);
        return pattern.At<Double1, Float1, Int1>(point).Value;
    }
}
