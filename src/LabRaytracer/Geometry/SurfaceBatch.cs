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

    /// <summary>Normal for shading, world space, length 1.</summary>
    public readonly R* ShadingX, ShadingY, ShadingZ;

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
        ShadingX = Column();
        ShadingY = Column();
        ShadingZ = Column();
        Slack = Column();
        Positions = new PositionBatch<R>
        {
            X = Column(), Y = Column(), Z = Column(),
            NormalX = Column(), NormalY = Column(), NormalZ = Column(),
            SurfaceU = Column(), SurfaceV = Column(),
        };
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
        ShadingX[packet] = s.ShadingX;
        ShadingY[packet] = s.ShadingY;
        ShadingZ[packet] = s.ShadingZ;
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

    /// <summary>Writes one surface point, taken from object space to world space.</summary>
    public void Put(int element, in SurfacePoint s, Transform transform)
    {
        Point3D point = transform.WorldFromObject(s.Point);
        Vector3D normal = transform.WorldNormalFromObject(s.Normal).Normalized();
        Vector3D shading = transform.WorldNormalFromObject(s.ShadingNormal).Normalized();
        Put(element, PointX, PointY, PointZ, point.ToVector());
        Put(element, NormalX, NormalY, NormalZ, normal);
        Put(element, ShadingX, ShadingY, ShadingZ, shading);
        Put(element, Positions.X, Positions.Y, Positions.Z, s.Position.LocalPoint.ToVector());
        Put(element, Positions.NormalX, Positions.NormalY, Positions.NormalZ, s.Position.LocalNormal);
        R.Put(Positions.SurfaceU, element, s.Position.Surface.U);
        R.Put(Positions.SurfaceV, element, s.Position.Surface.V);
        R.Put(Slack, element, transform.WorldSlack(s.Point, s.Slack) + (R.IsSingle ? point.ToVector().Length * 1e-6 : 0));
    }

    private static void Put(int element, R* x, R* y, R* z, Vector3D value)
    {
        R.Put(x, element, value.X);
        R.Put(y, element, value.Y);
        R.Put(z, element, value.Z);
    }
}
