using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Widths of footprints for patterns that know no direction: the longer of both steps.</summary>
internal static unsafe class FootprintWidth
{
    /// <summary>Widths of a group of lookups in the space of a pattern; 0 where lookups have no footprints.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Of<R, F>(in LookupBatch<R> lookups, PatternSpace space, int packet)
        where R : unmanaged, IReal<R>
        where F : unmanaged, IReal<F>
    {
        if (space == PatternSpace.Uv)
        {
            FootprintColumns flat = lookups.Footprints;
            return flat.DuDx == null
                ? F.Zero
                : Longer(((F*)flat.DuDx)[packet], ((F*)flat.DvDx)[packet], F.Zero, ((F*)flat.DuDy)[packet], ((F*)flat.DvDy)[packet], F.Zero);
        }

        LocalFootprintColumns local = lookups.LocalFootprints;
        return local.XDx == null
            ? F.Zero
            : Longer(
                ((F*)local.XDx)[packet], ((F*)local.YDx)[packet], ((F*)local.ZDx)[packet],
                ((F*)local.XDy)[packet], ((F*)local.YDy)[packet], ((F*)local.ZDy)[packet]);
    }

    /// <summary>The width of one lookup.</summary>
    public static Float1 Of(in TextureLookup lookup, PatternSpace space)
    {
        static Float1 Single(double number) => new((float)number);
        TextureFootprint flat = lookup.Footprint;
        SurfaceFootprint local = lookup.LocalFootprint;
        return space == PatternSpace.Uv
            ? Longer(Single(flat.DuDx), Single(flat.DvDx), Float1.Zero, Single(flat.DuDy), Single(flat.DvDy), Float1.Zero)
            : Longer(Single(local.DpDx.X), Single(local.DpDx.Y), Single(local.DpDx.Z), Single(local.DpDy.X), Single(local.DpDy.Y), Single(local.DpDy.Z));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Longer<F>(F x1, F y1, F z1, F x2, F y2, F z2)
        where F : unmanaged, IReal<F> => F.Sqrt(F.Max(Lane.Dot(x1, y1, z1, x1, y1, z1), Lane.Dot(x2, y2, z2, x2, y2, z2)));
}
