namespace LabRaytracer;

/// <summary>One lookup by the path for many: the same formulas with one lane.</summary>
internal static unsafe class ScalarSampler
{
    /// <summary>The colour at one place.</summary>
    public static Intensity Sample(TextureSampler sampler, in TextureLookup lookup)
    {
        Double1* place = stackalloc Double1[2];
        place[0] = new Double1(lookup.Coordinate.U);
        place[1] = new Double1(lookup.Coordinate.V);
        float* steps = stackalloc float[4];
        FootprintColumns footprints = new(steps, steps + 1, steps + 2, steps + 3);
        footprints.Put(0, lookup.Footprint);
        Float1* color = stackalloc Float1[3];
        LookupBatch<Double1> lookups = new()
        {
            Coordinates = new CoordinateBatch<Double1> { U = place, V = place + 1 },
            Footprints = footprints,
            WrapU = lookup.WrapU,
            WrapV = lookup.WrapV,
            Count = 1,
        };
        ColorColumns<Float1> colors = new() { R = color, G = color + 1, B = color + 2 };
        sampler.Sample<Double1, Float1, Int1>(lookups, colors, 1);
        return colors.Take(0);
    }
}
