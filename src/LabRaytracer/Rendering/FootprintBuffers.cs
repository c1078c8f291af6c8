namespace LabRaytracer;

/// <summary>The columns that footprints pass through; owned by one worker, only there if some texture is filtered.</summary>
internal sealed unsafe class FootprintBuffers<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly PositionBatch<F> _narrow;

    /// <param name="memory">Owns the columns.</param>
    /// <param name="capacity">Most hits of a batch.</param>
    /// <param name="sets">Most coordinate sets of a material.</param>
    public FootprintBuffers(LaneMemory memory, int capacity, int sets)
    {
        Steps = new SurfaceSteps<F>(memory, capacity);
        Gradients = new GradientBatch<F>(memory, capacity);
        Sets = new FootprintColumns[sets];
        for (int set = 0; set < sets; set++)
        {
            Sets[set] = new FootprintColumns(memory, capacity);
        }

        F* Column() => R.IsSingle ? null : memory.Column<F>(capacity, F.Width);
        _narrow = new PositionBatch<F>
        {
            X = Column(), Y = Column(), Z = Column(), NormalX = Column(), NormalY = Column(), NormalZ = Column(),
            WorldX = Column(), WorldY = Column(), WorldZ = Column(), SurfaceGradient = Steps.SurfaceGradient,
        };
        Local = LocalFootprintColumns.Of(Steps.LocalDx, Steps.LocalDy);
        World = LocalFootprintColumns.Of(Steps.WorldDx, Steps.WorldDy);
    }

    /// <summary>Steps on the surfaces of the group.</summary>
    public SurfaceSteps<F> Steps { get; }

    /// <summary>Gradients of one mapping.</summary>
    public GradientBatch<F> Gradients { get; }

    /// <summary>Footprints in texture space, one set a distinct mapping of the material.</summary>
    public FootprintColumns[] Sets { get; }

    /// <summary>Footprints on the surfaces: the steps in local space.</summary>
    public LocalFootprintColumns Local { get; }

    /// <summary>Footprints on the surfaces: the steps in world space.</summary>
    public LocalFootprintColumns World { get; }

    /// <summary>Points and normals of a group rounded to float, for gradients, which need no more.</summary>
    /// <param name="positions">The points.</param>
    /// <param name="packets">Groups of lanes.</param>
    /// <param name="hasWorld">Whether world points are read too.</param>
    public PositionBatch<F> Narrow(in PositionBatch<R> positions, int packets, bool hasWorld)
    {
        PositionBatch<R> from = positions;
        PositionBatch<F> to = _narrow;
        if (R.IsSingle)
        {
            to.X = (F*)from.X;
            to.Y = (F*)from.Y;
            to.Z = (F*)from.Z;
            to.NormalX = (F*)from.NormalX;
            to.NormalY = (F*)from.NormalY;
            to.NormalZ = (F*)from.NormalZ;
            to.WorldX = (F*)from.WorldX;
            to.WorldY = (F*)from.WorldY;
            to.WorldZ = (F*)from.WorldZ;
            return to;
        }

        for (int packet = 0; packet < packets; packet++)
        {
            to.X[packet] = R.ToSingle(from.X[packet]);
            to.Y[packet] = R.ToSingle(from.Y[packet]);
            to.Z[packet] = R.ToSingle(from.Z[packet]);
            to.NormalX[packet] = R.ToSingle(from.NormalX[packet]);
            to.NormalY[packet] = R.ToSingle(from.NormalY[packet]);
            to.NormalZ[packet] = R.ToSingle(from.NormalZ[packet]);
        }

        for (int packet = 0; hasWorld && packet < packets; packet++)
        {
            to.WorldX[packet] = R.ToSingle(from.WorldX[packet]);
            to.WorldY[packet] = R.ToSingle(from.WorldY[packet]);
            to.WorldZ[packet] = R.ToSingle(from.WorldZ[packet]);
        }

        return to;
    }
}
