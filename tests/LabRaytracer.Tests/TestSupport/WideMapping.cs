namespace LabRaytracer.Tests;

/// <summary>Runs built-in mappings and lane functions over arrays at any width.</summary>
internal static unsafe class WideMapping
{
    /// <summary>Maps points through the batch door at the width and precision of a lane type.</summary>
    public static (double[] U, double[] V) Map<R>(IMapping mapping, IReadOnlyList<SurfacePosition> positions)
        where R : unmanaged, IReal<R>
    {
        LaneColumn<R> Column(Func<SurfacePosition, double> number) => new([.. positions.Select(number)]);
        using LaneColumn<R> x = Column(p => p.LocalPoint.X), y = Column(p => p.LocalPoint.Y), z = Column(p => p.LocalPoint.Z);
        using LaneColumn<R> nx = Column(p => p.LocalNormal.X), ny = Column(p => p.LocalNormal.Y), nz = Column(p => p.LocalNormal.Z);
        using LaneColumn<R> su = Column(p => p.Surface.U), sv = Column(p => p.Surface.V);
        using LaneColumn<R> u = new(positions.Count), v = new(positions.Count);
        var batch = new PositionBatch<R>
        {
            X = x.Lanes, Y = y.Lanes, Z = z.Lanes,
            NormalX = nx.Lanes, NormalY = ny.Lanes, NormalZ = nz.Lanes,
            SurfaceU = su.Lanes, SurfaceV = sv.Lanes,
        };
        ((IWideMapping)mapping).Map(batch, new CoordinateBatch<R> { U = u.Lanes, V = v.Lanes }, x.Packets);
        return (u.ToArray(), v.ToArray());
    }

    /// <summary>Gradients of points through the batch door at the width and precision of a lane type.</summary>
    public static MappingGradient[] Gradients<T>(IMapping mapping, IReadOnlyList<SurfacePosition> positions)
        where T : unmanaged, IReal<T>
    {
        LaneColumn<T> Column(Func<SurfacePosition, double> number) => new([.. positions.Select(number)]);
        using LaneColumn<T> x = Column(p => p.LocalPoint.X), y = Column(p => p.LocalPoint.Y), z = Column(p => p.LocalPoint.Z);
        using LaneColumn<T> nx = Column(p => p.LocalNormal.X), ny = Column(p => p.LocalNormal.Y), nz = Column(p => p.LocalNormal.Z);
        using LaneMemory memory = new();
        var batch = new PositionBatch<T>
        {
            X = x.Lanes, Y = y.Lanes, Z = z.Lanes,
            NormalX = nx.Lanes, NormalY = ny.Lanes, NormalZ = nz.Lanes,
            SurfaceGradient = new GradientBatch<T>(memory, positions.Count),
        };
        GradientBatch<T> gradients = new(memory, positions.Count);
        for (int i = 0; i < positions.Count; i++)
        {
            batch.SurfaceGradient.Put(i, positions[i].SurfaceGradient);
        }

        ((IWideMapping)mapping).Gradients(batch, gradients, x.Packets);
        return [.. Enumerable.Range(0, positions.Count).Select(i => gradients.Take(i))];
    }

    /// <summary>Applies a function of two numbers at the width and precision of a lane type.</summary>
    public static double[] Apply<R>(Func<R, R, R> function, IReadOnlyList<double> first, IReadOnlyList<double> second)
        where R : unmanaged, IReal<R>
    {
        using LaneColumn<R> a = new(first), b = new(second), result = new(first.Count);
        for (int i = 0; i < a.Packets; i++)
        {
            result.Lanes[i] = function(a.Lanes[i], b.Lanes[i]);
        }

        return result.ToArray();
    }
}
