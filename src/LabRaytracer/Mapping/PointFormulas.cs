using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The two ways to run a formula: for one point and for a batch. Both give the same bits.</summary>
/// <remarks>
/// The compiler inlines a formula as a whole only below a method that is itself not inlined, and only while every level in between asks
/// for it: hence the attributes here, in <see cref="Elementary"/> and in the lane types, and "no inlining" at the mappings' doors.
/// </remarks>
internal static class PointFormulas
{
    /// <summary>Maps one point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static TextureCoordinate Map<TFormula>(Point3D point)
        where TFormula : struct, IPointFormula
    {
        (Double1 u, Double1 v) = TFormula.Coordinates(new Double1(point.X), new Double1(point.Y), new Double1(point.Z));
        return new TextureCoordinate(u.Value, v.Value);
    }

    /// <summary>Gradient at one point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MappingGradient Gradient<TFormula>(Point3D point)
        where TFormula : struct, IPointFormula
    {
        TFormula.Gradient(new Double1(point.X), new Double1(point.Y), new Double1(point.Z), out GradientLanes<Double1> g);
        return Of(g);
    }

    /// <summary>One gradient as a public value.</summary>
    public static MappingGradient Of(in GradientLanes<Double1> g) =>
        new(new Vector3D(g.UX.Value, g.UY.Value, g.UZ.Value), new Vector3D(g.VX.Value, g.VY.Value, g.VZ.Value));

    /// <summary>Gradients of the first groups of lanes of a batch.</summary>
    public static unsafe void Gradients<TFormula, T>(in PositionBatch<T> positions, in GradientBatch<T> gradients, int packets)
        where TFormula : struct, IPointFormula
        where T : unmanaged, IReal<T>
    {
        PositionBatch<T> points = positions;
        for (int i = 0; i < packets; i++)
        {
            TFormula.Gradient(points.X[i], points.Y[i], points.Z[i], out GradientLanes<T> g);
            gradients.Store(i, g);
        }
    }

    /// <summary>Changes of u and v over two steps of the local points, for the first groups of lanes of a batch; in floats.</summary>
    /// <param name="positions">The points.</param>
    /// <param name="stepX">Their steps over a sample to the right.</param>
    /// <param name="stepY">Their steps over a sample down.</param>
    /// <param name="changes">Receives the changes.</param>
    /// <param name="packets">Groups of lanes.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static unsafe void Changes<TFormula, R, F, I>(
        in PositionBatch<R> positions, in VectorColumns<F> stepX, in VectorColumns<F> stepY, in FootprintColumns changes, int packets)
        where TFormula : struct, IPointFormula
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R* px = positions.X, py = positions.Y, pz = positions.Z;
        for (int i = 0; i < packets; i++)
        {
            TFormula.Gradient(R.ToSingle(px[i]), R.ToSingle(py[i]), R.ToSingle(pz[i]), out GradientLanes<F> g);
            F x = stepX.X[i], y = stepX.Y[i], z = stepX.Z[i];
            ((F*)changes.DuDx)[i] = Lane.Dot(g.UX, g.UY, g.UZ, x, y, z);
            ((F*)changes.DvDx)[i] = Lane.Dot(g.VX, g.VY, g.VZ, x, y, z);
            x = stepY.X[i];
            y = stepY.Y[i];
            z = stepY.Z[i];
            ((F*)changes.DuDy)[i] = Lane.Dot(g.UX, g.UY, g.UZ, x, y, z);
            ((F*)changes.DvDy)[i] = Lane.Dot(g.VX, g.VY, g.VZ, x, y, z);
        }
    }

    /// <summary>Maps the first groups of lanes of a batch.</summary>
    public static unsafe void Map<TFormula, R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets)
        where TFormula : struct, IPointFormula
        where R : unmanaged, IReal<R>
    {
        // Eight doubles are two registers of which there are few: half as many lanes at a time stay in them.
        if (typeof(R) == typeof(Double8))
        {
            Each<TFormula, Double4>(
                Unsafe.As<PositionBatch<R>, PositionBatch<Double4>>(ref Unsafe.AsRef(in positions)),
                Unsafe.As<CoordinateBatch<R>, CoordinateBatch<Double4>>(ref Unsafe.AsRef(in coordinates)),
                2 * packets);
            return;
        }

        Each<TFormula, R>(positions, coordinates, packets);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static unsafe void Each<TFormula, R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets)
        where TFormula : struct, IPointFormula
        where R : unmanaged, IReal<R>
    {
        PositionBatch<R> points = positions;
        CoordinateBatch<R> results = coordinates;
        for (int i = 0; i < packets; i++)
        {
            (results.U[i], results.V[i]) = TFormula.Coordinates(points.X[i], points.Y[i], points.Z[i]);
        }
    }
}
