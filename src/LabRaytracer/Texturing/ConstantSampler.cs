namespace LabRaytracer;

/// <summary>The same colour everywhere, for parts of combined textures.</summary>
internal sealed unsafe class ConstantSampler(Intensity color) : TextureSampler
{
    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        for (int packet = 0; packet < packets; packet++)
        {
            colors.R[packet] = F.Of(color.R);
            colors.G[packet] = F.Of(color.G);
            colors.B[packet] = F.Of(color.B);
        }
    }
}
