namespace LabRaytracer;

/// <summary>Stacks of layers over a coefficient.</summary>
internal static unsafe class LayerStage
{
    /// <summary>Writes the coefficients on top of all layers.</summary>
    /// <param name="stack">The coefficient and its layers.</param>
    /// <param name="buffers">Texels of the lookups before; coordinates.</param>
    /// <param name="target">Number of the lookup that is written.</param>
    /// <param name="packets">Groups of lanes.</param>
    public static void Run<R, F, I>(LayerStack stack, ShadingBuffers<R, F, I> buffers, int target, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        ColorColumns<F> result = buffers.Texels[target];
        for (int packet = 0; packet < packets; packet++)
        {
            stack.Base.Read(buffers.Texels, packet, out result.R[packet], out result.G[packet], out result.B[packet]);
        }

        foreach (CompiledLayer layer in stack.Layers)
        {
            for (int packet = 0; packet < packets; packet++)
            {
                Add(layer, buffers, result, packet);
            }
        }
    }

    private static void Add<R, F, I>(in CompiledLayer layer, ShadingBuffers<R, F, I> buffers, in ColorColumns<F> result, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F red = F.Of(layer.Color.R), green = F.Of(layer.Color.G), blue = F.Of(layer.Color.B);
        if (layer.Lookup >= 0)
        {
            ColorColumns<F> texels = buffers.Texels[layer.Lookup];
            (red, green, blue) = (texels.R[packet], texels.G[packet], texels.B[packet]);
        }

        F alpha = layer.AlphaLookup >= 0 ? buffers.Texels[layer.AlphaLookup].R[packet] : F.Of(layer.Alpha);
        if (layer.Coordinates >= 0)
        {
            F there = Inside<R, F, I>(buffers.Coordinates[layer.Coordinates], packet);
            red &= there;
            green &= there;
            blue &= there;
            alpha &= there;
        }

        result.R[packet] = layer.Apply(result.R[packet], red, alpha);
        result.G[packet] = layer.Apply(result.G[packet], green, alpha);
        result.B[packet] = layer.Apply(result.B[packet], blue, alpha);
    }

    /// <summary>Mask of the coordinates in the unit square, its edges included.</summary>
    private static F Inside<R, F, I>(in CoordinateBatch<R> coordinates, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R u = coordinates.U[packet], v = coordinates.V[packet], one = R.Of(1);
        return R.MaskToSingle(R.LessOrEqual(R.Zero, u) & R.LessOrEqual(u, one) & R.LessOrEqual(R.Zero, v) & R.LessOrEqual(v, one));
    }
}
