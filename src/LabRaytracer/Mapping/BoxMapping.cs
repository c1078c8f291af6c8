using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The cube [-1, 1]³: every face shows the whole picture, none mirrored.</summary>
/// <remarks>
/// <para>The face is the one whose axis has the largest |component| of the normal; x before y before z among equals. Seen from outside:</para>
/// <list type="bullet">
/// <item>the sides +X, -X, +Z, -Z stand upright: v goes up along +Y, u to the right;</item>
/// <item>the top +Y continues the face +Z over its upper edge: u along +X, v along -Z;</item>
/// <item>the bottom -Y continues the face +Z below its lower edge: u along +X, v along +Z.</item>
/// </list>
/// <para>u and v are correctly rounded, [0, 1] with both ends on the cube.</para>
/// <list type="table">
/// <listheader><term>face; local point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>+X; (1, 0.5, -0.5)</term><description>(0.75, 0.75)</description></item>
/// <item><term>-X; (-1, 0.5, -0.5)</term><description>(0.25, 0.75)</description></item>
/// <item><term>+Y; (0.5, 1, -0.5)</term><description>(0.75, 0.75)</description></item>
/// <item><term>-Y; (0.5, -1, -0.5)</term><description>(0.75, 0.25)</description></item>
/// <item><term>+Z; (0.5, -0.5, 1)</term><description>(0.75, 0.25)</description></item>
/// <item><term>-Z; (0.5, -0.5, -1)</term><description>(0.25, 0.25)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class BoxMapping : IWideMapping
{
    bool IWideMapping.NeedsNormal => true;

    /// <inheritdoc/>
    public TextureCoordinate Map(in SurfacePosition position)
    {
        Point3D p = position.LocalPoint;
        Vector3D n = position.LocalNormal;
        (Double1 u, Double1 v) = Coordinates<Double1>(new(p.X), new(p.Y), new(p.Z), new(n.X), new(n.Y), new(n.Z));
        return new TextureCoordinate(u.Value, v.Value);
    }

    /// <inheritdoc/>
    public MappingGradient Gradient(in SurfacePosition position)
    {
        Vector3D n = position.LocalNormal;
        Slopes<Double1>(new(n.X), new(n.Y), new(n.Z), out GradientLanes<Double1> gradient);
        return PointFormulas.Of(gradient);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (T U, T V) Coordinates<T>(T x, T y, T z, T normalX, T normalY, T normalZ)
        where T : unmanaged, IReal<T>
    {
        (T onX, T onY) = Face(normalX, normalY, normalZ);
        T right = T.Select(onX, T.Select(T.Less(normalX, T.Zero), z, -z), T.Select(onY | T.LessOrEqual(T.Zero, normalZ), x, -x));
        T up = T.Select(onY, T.Select(T.Less(normalY, T.Zero), z, -z), y);
        return ((right + T.Of(1)) * T.Of(0.5), (up + T.Of(1)) * T.Of(0.5));
    }

    /// <summary>Masks of points on the sides across x, and on top or bottom.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (T OnX, T OnY) Face<T>(T normalX, T normalY, T normalZ)
        where T : unmanaged, IReal<T>
    {
        T ax = T.Abs(normalX);
        T ay = T.Abs(normalY);
        T az = T.Abs(normalZ);
        T onX = T.LessOrEqual(ay, ax) & T.LessOrEqual(az, ax);
        return (onX, ~onX & T.LessOrEqual(az, ay));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Slopes<T>(T normalX, T normalY, T normalZ, out GradientLanes<T> gradient)
        where T : unmanaged, IReal<T>
    {
        (T onX, T onY) = Face(normalX, normalY, normalZ);
        T half = T.Of(0.5);
        gradient = default;
        gradient.UZ = onX & T.Select(T.Less(normalX, T.Zero), half, -half);
        gradient.UX = T.Select(onX, T.Zero, T.Select(onY | T.LessOrEqual(T.Zero, normalZ), half, -half));
        gradient.VZ = onY & T.Select(T.Less(normalY, T.Zero), half, -half);
        gradient.VY = T.Select(onY, T.Zero, half);
    }

    unsafe void IWideMapping.Gradients<T>(in PositionBatch<T> positions, in GradientBatch<T> gradients, int packets)
    {
        for (int i = 0; i < packets; i++)
        {
            Slopes(positions.NormalX[i], positions.NormalY[i], positions.NormalZ[i], out GradientLanes<T> gradient);
            gradients.Store(i, gradient);
        }
    }

    unsafe void IWideMapping.Map<R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets)
    {
        for (int i = 0; i < packets; i++)
        {
            (coordinates.U[i], coordinates.V[i]) = Coordinates(
                positions.X[i], positions.Y[i], positions.Z[i], positions.NormalX[i], positions.NormalY[i], positions.NormalZ[i]);
        }
    }
}
