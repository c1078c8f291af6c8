using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The cone around +Y with its apex at y = 1 and a base of radius 1 at y = -1: the side unrolled by angle and height, the base as a flat picture.</summary>
/// <remarks>
/// <para>Side: u = phi / 2 pi with phi = atan2(x, z), v = (y + 1) / 2, which is also the share of the slant height. Base, where the normal points down: u = (x + 1) / 2,
/// v = (z + 1) / 2, not mirrored seen from below.</para>
/// <para>Side: u in [0, 1), 0 on the axis, within 1 ulp; v correctly rounded, [0, 1]. Base: both correctly rounded, [0, 1]. The top edge of the picture is the apex.
/// The seam u = 0 is the line x = 0, z &gt; 0.</para>
/// <para>The gradient of u on the side is that of <see cref="CylindricalMapping"/>, the others are constant.</para>
/// <list type="table">
/// <listheader><term>local point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>(0, -1, 1)</term><description>(0, 0)</description></item>
/// <item><term>(0.5, 0, 0)</term><description>(0.25, 0.5)</description></item>
/// <item><term>(0, 0, -0.5)</term><description>(0.5, 0.5)</description></item>
/// <item><term>(0, 1, 0)</term><description>(0, 1)</description></item>
/// <item><term>(-0.25, 0.5, 0)</term><description>(0.75, 0.75)</description></item>
/// <item><term>(0.5, -1, -0.5), normal (0, -1, 0)</term><description>(0.75, 0.25)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class ConeMapping : IWideMapping
{
    bool IWideMapping.NeedsNormal => true;

    /// <summary>u runs around the axis.</summary>
    public bool ClosesU => true;

    /// <summary>Clamp: the picture ends at both ends of v.</summary>
    public TextureWrap DefaultWrapV => TextureWrap.Clamp;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public TextureCoordinate Map(in SurfacePosition position)
    {
        Point3D p = position.LocalPoint;
        (Double1 u, Double1 v) = Coordinates<Double1>(new(p.X), new(p.Y), new(p.Z), new(position.LocalNormal.Y));
        return new TextureCoordinate(u.Value, v.Value);
    }

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public MappingGradient Gradient(in SurfacePosition position)
    {
        Slopes<Double1>(new(position.LocalPoint.X), new(position.LocalPoint.Z), new(position.LocalNormal.Y), out GradientLanes<Double1> gradient);
        return PointFormulas.Of(gradient);
    }

    unsafe void IWideMapping.Map<R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets)
    {
        for (int i = 0; i < packets; i++)
        {
            (coordinates.U[i], coordinates.V[i]) = Coordinates(positions.X[i], positions.Y[i], positions.Z[i], positions.NormalY[i]);
        }
    }

    unsafe void IWideMapping.Gradients<T>(in PositionBatch<T> positions, in GradientBatch<T> gradients, int packets)
    {
        for (int i = 0; i < packets; i++)
        {
            Slopes(positions.X[i], positions.Z[i], positions.NormalY[i], out GradientLanes<T> gradient);
            gradients.Store(i, gradient);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (T U, T V) Coordinates<T>(T x, T y, T z, T normalY)
        where T : unmanaged, IReal<T>
    {
        T isBase = T.Less(normalY, T.Zero), half = T.Of(0.5), one = T.Of(1);
        return (T.Select(isBase, (x + one) * half, Elementary.Atan2Turns(x, z)), T.Select(isBase, (z + one) * half, (y + one) * half));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Slopes<T>(T x, T z, T normalY, out GradientLanes<T> gradient)
        where T : unmanaged, IReal<T>
    {
        T isBase = T.Less(normalY, T.Zero), half = T.Of(0.5);
        AngleGradient<T> angle = new(Elementary.Finite(x), Elementary.Finite(z));
        gradient = default;
        gradient.UX = T.Select(isBase, half, angle.X);
        gradient.UZ = T.Select(isBase, T.Zero, angle.Z);
        gradient.VY = T.Select(isBase, T.Zero, half);
        gradient.VZ = isBase & half;
    }
}
