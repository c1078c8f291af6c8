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

    /// <summary>Maps the first groups of lanes of a batch.</summary>
    public static unsafe void Map<TFormula, R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets)
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
