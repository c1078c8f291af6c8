namespace LabRaytracer;

/// <summary>Looks up a picture and shows its border colour outside of it, many points at a time.</summary>
/// <param name="picture">The picture.</param>
/// <param name="options">How it is looked up.</param>
internal sealed unsafe class BorderSampler(TextureSampler picture, SamplingOptions options) : TextureSampler
{
    protected override IReadOnlyList<TextureSampler> Sources => [picture];

    public override (TexelAxis Across, TexelAxis Up)? FindAxes(IMapping mapping) => picture.FindAxes(mapping);

    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        picture.Sample<R, F, I>(lookups, colors, packets);

        // Where something is outside does not depend on the size.
        TexelAxis across = new(1, options.WrapU ?? lookups.WrapU, options.Texels), up = new(1, options.WrapV ?? lookups.WrapV, options.Texels);
        if (across.Wrap != TextureWrap.Border && up.Wrap != TextureWrap.Border)
        {
            return;
        }

        F red = F.Of(options.BorderColor.R), green = F.Of(options.BorderColor.G), blue = F.Of(options.BorderColor.B);
        for (int packet = 0; packet < packets; packet++)
        {
            F outside = R.MaskToSingle(across.Outside(lookups.Coordinates.U[packet]) | up.Outside(lookups.Coordinates.V[packet]));
            colors.R[packet] = F.Select(outside, red, colors.R[packet]);
            colors.G[packet] = F.Select(outside, green, colors.G[packet]);
            colors.B[packet] = F.Select(outside, blue, colors.B[packet]);
        }
    }
}
