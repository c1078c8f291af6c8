using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Columns of surface points of one group of hits, world space.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
internal sealed unsafe class SurfaceBatch<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Hit point, world space.</summary>
    public readonly R* PointX, PointY, PointZ;

    /// <summary>Outward geometric normal, world space, length 1.</summary>
    public readonly R* NormalX, NormalY, NormalZ;

    private readonly R* _shadingX, _shadingY, _shadingZ;

    /// <summary>Bound of the error of each coordinate of the point, world space.</summary>
    public readonly R* Slack;

    /// <summary>What mappings read.</summary>
    public readonly PositionBatch<R> Positions;

    public SurfaceBatch(LaneMemory memory, int capacity)
    {
        R* Column() => memory.Column<R>(capacity, R.Width);
        PointX = Column();
        PointY = Column();
        PointZ = Column();
        NormalX = Column();
        NormalY = Column();
        NormalZ = Column();
        _shadingX = Column();
        _shadingY = Column();
        _shadingZ = Column();
        Slack = Column();
        Positions = new PositionBatch<R>
        {
            X = Column(), Y = Column(), Z = Column(),
            NormalX = Column(), NormalY = Column(), NormalZ = Column(),
            WorldX = PointX, WorldY = PointY, WorldZ = PointZ,
            WorldNormalX = NormalX, WorldNormalY = NormalY, WorldNormalZ = NormalZ,
            SurfaceU = Column(), SurfaceV = Column(),
        };
    }

    /// <summary>Tells whether normals for shading are the geometric ones: then both are the same columns.</summary>
    public bool SharesNormals { get; set; }

    /// <summary>Normal for shading, world space, length 1.</summary>
    public R* ShadingX => SharesNormals ? NormalX : _shadingX;

    /// <summary>Normal for shading, world space, length 1.</summary>
    public R* ShadingY => SharesNormals ? NormalY : _shadingY;

    /// <summary>Normal for shading, world space, length 1.</summary>
    public R* ShadingZ => SharesNormals ? NormalZ : _shadingZ;

    /// <summary>The columns that kernels write themselves.</summary>
    public SurfaceColumns<R> Columns => new() { Positions = Positions, Slack = Slack };

    /// <summary>Gives the normals for shading columns of their own, because they are about to be tilted.</summary>
    public void SeparateNormals(int packets)
    {
        if (SharesNormals)
        {
            new ReadOnlySpan<R>(NormalX, packets).CopyTo(new Span<R>(_shadingX, packets));
            new ReadOnlySpan<R>(NormalY, packets).CopyTo(new Span<R>(_shadingY, packets));
            new ReadOnlySpan<R>(NormalZ, packets).CopyTo(new Span<R>(_shadingZ, packets));
            SharesNormals = false;
        }
    }

    /// <summary>Writes one group of lanes.</summary>
    /// <param name="packet">Group of lanes.</param>
    /// <param name="s">Surface points, world space.</param>
    /// <param name="needs">Columns that somebody reads.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(int packet, in SurfaceLanes<R> s, SurfaceNeeds needs)
    {
        PointX[packet] = s.PointX;
        PointY[packet] = s.PointY;
        PointZ[packet] = s.PointZ;
        NormalX[packet] = s.NormalX;
        NormalY[packet] = s.NormalY;
        NormalZ[packet] = s.NormalZ;
        SharesNormals = false;
        _shadingX[packet] = s.ShadingX;
        _shadingY[packet] = s.ShadingY;
        _shadingZ[packet] = s.ShadingZ;
        Slack[packet] = s.Slack;
        if ((needs & SurfaceNeeds.LocalPoint) != 0)
        {
            Positions.X[packet] = s.LocalX;
            Positions.Y[packet] = s.LocalY;
            Positions.Z[packet] = s.LocalZ;
        }

        if ((needs & SurfaceNeeds.LocalNormal) != 0)
        {
            Positions.NormalX[packet] = s.LocalNormalX;
            Positions.NormalY[packet] = s.LocalNormalY;
            Positions.NormalZ[packet] = s.LocalNormalZ;
        }

        if ((needs & SurfaceNeeds.SurfaceCoordinates) != 0)
        {
            Positions.SurfaceU[packet] = s.SurfaceU;
            Positions.SurfaceV[packet] = s.SurfaceV;
        }
    }

    /// <summary>Writes one surface point, taken from object space to world space by the formulas of built-in shapes.</summary>
    public void Put(int element, in SurfacePoint point, Transform transform)
    {
        SurfaceLanes<Double1> s = SurfaceLanes.Of(point);
        if (!transform.IsIdentity)
        {
            Double1* numbers = stackalloc Double1[WorldSpace.ParameterCount];
            WorldSpace.Describe(transform, new Span<double>(numbers, WorldSpace.ParameterCount));
            WorldSpace.FromObject(new SharedParameters<Double1, Float1, Int1>(numbers, 0), ref s);
        }

        Put(element, PointX, PointY, PointZ, s.PointX, s.PointY, s.PointZ);
        Put(element, NormalX, NormalY, NormalZ, s.NormalX, s.NormalY, s.NormalZ);
        SharesNormals = false;
        Put(element, _shadingX, _shadingY, _shadingZ, s.ShadingX, s.ShadingY, s.ShadingZ);
        Put(element, Positions.X, Positions.Y, Positions.Z, s.LocalX, s.LocalY, s.LocalZ);
        Put(element, Positions.NormalX, Positions.NormalY, Positions.NormalZ, s.LocalNormalX, s.LocalNormalY, s.LocalNormalZ);
        R.Put(Positions.SurfaceU, element, s.SurfaceU.Value);
        R.Put(Positions.SurfaceV, element, s.SurfaceV.Value);

        // Float lanes round the point once more.
        double size = Math.Abs(s.PointX.Value) + Math.Abs(s.PointY.Value) + Math.Abs(s.PointZ.Value);
        R.Put(Slack, element, s.Slack.Value + (R.IsSingle ? Lane.Slack(new Float1((float)size)).Value : 0));
    }

    private static void Put(int element, R* toX, R* toY, R* toZ, Double1 x, Double1 y, Double1 z)
    {
        R.Put(toX, element, x.Value);
        R.Put(toY, element, y.Value);
        R.Put(toZ, element, z.Value);
    }
}
