namespace LabRaytracer;

/// <summary>The view that shows which texel each pixel reads.</summary>
internal static unsafe class TexelView
{
    /// <summary>What has no picture texture.</summary>
    public static readonly Intensity NoPicture = Intensity.Grey(0.25f);

    /// <summary>Writes the colours of the texels that nearest lookup would read as radiance.</summary>
    public static void Run<R, F, I>(CompiledMaterial material, ShadingBuffers<R, F, I> buffers, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        foreach (CompiledLookup lookup in material.Lookups)
        {
            if (lookup.Coordinates >= 0 && lookup.Sampler?.FindAxes(material.Coordinates[lookup.Coordinates].Mapping) is { } axes)
            {
                CoordinateBatch<R> coordinates = buffers.Coordinates[lookup.Coordinates];
                TextureStage.Map(material.Coordinates[lookup.Coordinates], buffers.Surfaces.Positions, coordinates, count, (count + R.Width - 1) / R.Width);
                Show(axes.Across, axes.Up, coordinates, buffers, count);
                return;
            }
        }

        for (int i = 0; i < count; i++)
        {
            buffers.Radiance.Put(i, NoPicture);
        }
    }

    private static void Show<R, F, I>(TexelAxis across, TexelAxis up, CoordinateBatch<R> coordinates, ShadingBuffers<R, F, I> buffers, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            R outside = across.Nearest<R, F, I>(coordinates.U[packet], out I x) | up.Nearest<R, F, I>(coordinates.V[packet], out I y);
            uint off = R.Bits(outside);
            for (int lane = 0; lane < R.Width && (packet * R.Width) + lane < count; lane++)
            {
                int i = (packet * R.Width) + lane;
                bool isFinite = double.IsFinite(R.Take(coordinates.U, i)) && double.IsFinite(R.Take(coordinates.V, i));
                Intensity color = (off >> lane & 1) != 0 ? Intensity.Black : Color(((int*)&x)[lane], ((int*)&y)[lane]);
                buffers.Radiance.Put(i, isFinite ? color : Intensity.Grey(float.NaN));
            }
        }
    }

    /// <summary>Colour of a texel: scattered by its numbers, light and dark as on a chessboard, so that neighbours differ in every channel.</summary>
    private static Intensity Color(int x, int y)
    {
        uint hash = ((uint)x * 0x9E3779B1) ^ ((uint)y * 0x85EBCA77);
        hash = (hash ^ (hash >> 15)) * 0x2C1B3C6D;
        hash ^= hash >> 13;
        bool isLight = ((x + y) & 1) == 0;
        float least = isLight ? 0.5f : 0.05f, step = (isLight ? 0.5f : 0.25f) / 255;
        return new Intensity(least + (step * (hash & 255)), least + (step * ((hash >> 8) & 255)), least + (step * ((hash >> 16) & 255)));
    }
}
