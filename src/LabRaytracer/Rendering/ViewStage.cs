namespace LabRaytracer;

/// <summary>Views that show geometry instead of light.</summary>
internal static unsafe class ViewStage
{
    /// <summary>Columns of surface points that a mapping may read.</summary>
    public const SurfaceNeeds MappingNeeds = SurfaceNeeds.LocalPoint | SurfaceNeeds.LocalNormal | SurfaceNeeds.SurfaceCoordinates;

    /// <summary>Tells whether a view needs light to be computed.</summary>
    public static bool IsShaded(RenderView view) => view is RenderView.Color or RenderView.Nan or RenderView.Cost or RenderView.Seam or RenderView.Samples;

    /// <summary>Tells whether a view's samples are those of the picture proper, as many as its light asks for.</summary>
    public static bool IsColor(RenderView view) => view is RenderView.Color or RenderView.Nan or RenderView.Samples;

    /// <summary>Columns of surface points that a view reads.</summary>
    public static SurfaceNeeds Needs(RenderView view) => view == RenderView.Uv || FilterView.Is(view)
        ? MappingNeeds
        : view == RenderView.Depth ? SurfaceNeeds.Parameter : SurfaceNeeds.None;

    /// <summary>Writes the view's colours as radiance.</summary>
    /// <param name="view">The view.</param>
    /// <param name="hits">Hits of the batch.</param>
    /// <param name="travelled">How far rays had come before, by ray; null for not at all.</param>
    /// <param name="order">Numbers of the rays that hit.</param>
    /// <param name="count">How many.</param>
    /// <param name="material">Their material.</param>
    /// <param name="buffers">Their surface points; receives the colours.</param>
    public static void Run<R, F, I>(
        RenderView view, HitBatch<R, F, I> hits, R* travelled, int* order, int count, CompiledMaterial material, ShadingBuffers<R, F, I> buffers)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (FilterView.Is(view))
        {
            FilterView.Run(view, material, buffers, count);
            return;
        }

        if (view == RenderView.Texel)
        {
            TexelView.Run(material, buffers, count);
            return;
        }

        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        for (int i = 0; i < count; i++)
        {
            buffers.Radiance.Put(i, view switch
            {
                RenderView.Uv => Fractions(Map(material.DefaultMapping, s, i)),
                RenderView.Normal => Half(R.Take(s.ShadingX, i), R.Take(s.ShadingY, i), R.Take(s.ShadingZ, i)),
                RenderView.Depth => Intensity.Grey((float)(1 / (1 + (R.Take(hits.T, order[i]) + (travelled == null ? 0 : R.Take(travelled, order[i])))))),
                _ => ObjectColor(((int*)hits.Object)[order[i]]),
            });
        }
    }

    /// <summary>The colour of an object's number: hues a golden angle apart.</summary>
    private static Intensity ObjectColor(int number)
    {
        double hue = 6 * ((number * 0.6180339887498949) % 1);
        return new Intensity(Channel(hue), Channel((hue + 4) % 6), Channel((hue + 2) % 6));
    }

    private static float Channel(double hue) => (float)Math.Clamp(Math.Abs(hue - 3) - 1, 0.05, 1);

    private static Intensity Half(double x, double y, double z) => new((float)((x + 1) / 2), (float)((y + 1) / 2), (float)((z + 1) / 2));

    /// <summary>Texture coordinates of a point of a batch.</summary>
    public static TextureCoordinate Map<R, F, I>(IMapping mapping, SurfaceBatch<R, F, I> s, int i)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => mapping.Map(Position(s, i));

    /// <summary>What a mapping sees of a point of a batch.</summary>
    public static SurfacePosition Position<R, F, I>(SurfaceBatch<R, F, I> s, int i)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        PositionBatch<R> at = s.Positions;
        return new SurfacePosition(
            new Point3D(R.Take(at.X, i), R.Take(at.Y, i), R.Take(at.Z, i)),
            new Vector3D(R.Take(at.NormalX, i), R.Take(at.NormalY, i), R.Take(at.NormalZ, i)),
            new TextureCoordinate(R.Take(at.SurfaceU, i), R.Take(at.SurfaceV, i)))
        {
            WorldPoint = new Point3D(R.Take(at.WorldX, i), R.Take(at.WorldY, i), R.Take(at.WorldZ, i)),
        };
    }

    private static Intensity Fractions(TextureCoordinate mapped) =>
        new((float)(mapped.U - Math.Floor(mapped.U)), (float)(mapped.V - Math.Floor(mapped.V)), 0);
}
