using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The sphere around the origin, unrolled by longitude and latitude (Polish: mapowanie sferyczne).</summary>
/// <remarks>
/// <para>u = phi / 2 pi with phi = atan2(x, z), v = 1 - theta / pi with theta = atan2(sqrt(x² + z²), y): lab sheet IV, section 1.1.3,
/// with the polar form of theta instead of acos(y), which loses half of the digits near the poles and is undefined when rounding leaves |y| above 1.</para>
/// <para>u in [0, 1), v in [0, 1]; both within 1 ulp for every finite point, whatever its distance from the origin.
/// u = 0 on the axis, v = 1/2 at the origin. The seam u = 0 is the half meridian x = 0, z &gt; 0. A picture of aspect 2:1 fits.</para>
/// <para>The gradient of u is (z, 0, -x) / (2 pi rho²) with rho = sqrt(x² + z²), continuous across the seam; rho below 2^-20 of the largest coordinate counts as that,
/// so that on the unit sphere its length is at most 2^20 / 2 pi. That of v is (-x y, rho², -z y) / (pi rho r²), of length 1 / (pi r). Both are 0 at the origin.</para>
/// <list type="table">
/// <listheader><term>local point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>(0, 0, 1)</term><description>(0, 0.5)</description></item>
/// <item><term>(1, 0, 0)</term><description>(0.25, 0.5)</description></item>
/// <item><term>(0, 0, -1)</term><description>(0.5, 0.5)</description></item>
/// <item><term>(-1, 0, 0)</term><description>(0.75, 0.5)</description></item>
/// <item><term>(0, 1, 0)</term><description>(0, 1)</description></item>
/// <item><term>(0, -1, 0)</term><description>(0, 0)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class SphericalMapping : IWideMapping
{
    /// <summary>u runs around the axis.</summary>
    public bool ClosesU => true;

    /// <summary>Pole: filters go on at the other side of the poles.</summary>
    public TextureWrap DefaultWrapV => TextureWrap.Pole;

    /// <summary>Texture coordinates of a point.</summary>
    /// <param name="localPoint">The point in object space. For the angles NaN counts as 0 and infinity as the largest number: they stay in range.</param>
    public TextureCoordinate Map(Point3D localPoint)
    {
        // The same formula, both angles of the point at once.
        (double u, double v) = Elementary.SphereTurns(localPoint.X, localPoint.Y, localPoint.Z);
        return new TextureCoordinate(u, v);
    }

    /// <inheritdoc/>
    public TextureCoordinate Map(in SurfacePosition position) => Map(position.LocalPoint);

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public MappingGradient Gradient(in SurfacePosition position) => PointFormulas.Gradient<Formula>(position.LocalPoint);

    void IWideMapping.Map<R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets) =>
        PointFormulas.Map<Formula, R>(positions, coordinates, packets);

    void IWideMapping.Gradients<T>(in PositionBatch<T> positions, in GradientBatch<T> gradients, int packets) =>
        PointFormulas.Gradients<Formula, T>(positions, gradients, packets);

    internal readonly struct Formula : IPointFormula
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static (T U, T V) Coordinates<T>(T x, T y, T z)
            where T : unmanaged, IReal<T> => Elementary.SphereTurns(x, y, z);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Gradient<T>(T x, T y, T z, out GradientLanes<T> gradient)
            where T : unmanaged, IReal<T>
        {
            T size = T.Max(T.Max(T.Abs(x), T.Abs(y)), T.Abs(z));
            T isCenter = T.Less(size, T.Of(T.IsSingle ? 1e-30 : 1e-300));
            T scale = T.Select(isCenter, T.Zero, T.Of(1) / size);
            x *= scale;
            y *= scale;
            z *= scale;
            AngleGradient<T> angle = new(x, z);
            T distance = T.Fma(x, angle.Sin, z * angle.Cos);
            T slope = scale * T.Of(0.3183098861837907) / T.Select(isCenter, T.Of(1), T.Fma(y, y, distance * distance));
            gradient = default;
            gradient.UX = scale * angle.X;
            gradient.UZ = scale * angle.Z;
            gradient.VX = -y * angle.Sin * slope;
            gradient.VY = distance * slope;
            gradient.VZ = -y * angle.Cos * slope;
        }
    }
}
