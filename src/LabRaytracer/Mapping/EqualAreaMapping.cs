using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The sphere around the origin by longitude and height: equal areas of the sphere have equal areas on the picture (Lambert's cylindrical projection).</summary>
/// <remarks>
/// <para>u = phi / 2 pi with phi = atan2(x, z), v = (1 + y / r) / 2 with r = sqrt(x² + y² + z²).</para>
/// <para>u in [0, 1), v in [0, 1]; u within 1 ulp, v within 8, also where it is small. u = 0 on the axis, v = 1/2 at the origin. The length of (x, y, z) does not matter.
/// The seam u = 0 is the half meridian x = 0, z &gt; 0. A picture of aspect pi:1 has square texels at the equator.</para>
/// <para>The gradient of u is that of <see cref="SphericalMapping"/>; that of v is (-x y, x² + z², -z y) / (2 r³).</para>
/// <list type="table">
/// <listheader><term>local point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>(0, 0, 1)</term><description>(0, 0.5)</description></item>
/// <item><term>(1, 0, 0)</term><description>(0.25, 0.5)</description></item>
/// <item><term>(0, 1, 0)</term><description>(0, 1)</description></item>
/// <item><term>(0, -1, 0)</term><description>(0, 0)</description></item>
/// <item><term>(-4, 3, 0)</term><description>(0.75, 0.8)</description></item>
/// <item><term>(0, -3, -4)</term><description>(0.5, 0.2)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class EqualAreaMapping : IWideMapping
{
    /// <summary>u runs around the axis.</summary>
    public bool ClosesU => true;

    /// <summary>Clamp: the picture ends at both ends of v.</summary>
    public TextureWrap DefaultWrapV => TextureWrap.Clamp;

    /// <summary>Texture coordinates of a point.</summary>
    /// <param name="localPoint">The point in object space; NaN counts as 0 and infinity as the largest number.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public TextureCoordinate Map(Point3D localPoint) => PointFormulas.Map<Formula>(localPoint);

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public TextureCoordinate Map(in SurfacePosition position) => PointFormulas.Map<Formula>(position.LocalPoint);

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public MappingGradient Gradient(in SurfacePosition position) => PointFormulas.Gradient<Formula>(position.LocalPoint);

    void IWideMapping.Map<R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets) =>
        PointFormulas.Map<Formula, R>(positions, coordinates, packets);

    void IWideMapping.Gradients<T>(in PositionBatch<T> positions, in GradientBatch<T> gradients, int packets) =>
        PointFormulas.Gradients<Formula, T>(positions, gradients, packets);

    private readonly struct Formula : IPointFormula
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static (T U, T V) Coordinates<T>(T x, T y, T z)
            where T : unmanaged, IReal<T>
        {
            T u = Elementary.Atan2Turns(x, z);
            Elementary.ToUnitBox(ref x, ref y, ref z);
            T flat = T.Fma(x, x, z * z), square = T.Fma(y, y, flat), half = T.Of(0.5);
            square = T.Select(T.Equal(square, T.Zero), T.Of(1), square);
            T length = T.Sqrt(square);

            // Below the equator 1 + y / r = rho² / (r² - r y) does not cancel.
            T north = T.Fma(y / length, half, half);
            T south = half * flat / T.Fma(-length, y, square);
            return (u, T.Min(T.Select(T.Less(y, T.Zero), south, north), T.Of(1)));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Gradient<T>(T x, T y, T z, out GradientLanes<T> gradient)
            where T : unmanaged, IReal<T>
        {
            T scale = Elementary.GradientScale(Elementary.ToUnitBox(ref x, ref y, ref z));
            AngleGradient<T> angle = new(x, z);
            T flat = T.Fma(x, x, z * z), square = T.Fma(y, y, flat);
            T isOrigin = T.Equal(square, T.Zero);
            square = T.Select(isOrigin, T.Of(1), square);
            T slope = T.Select(isOrigin, T.Zero, scale * T.Of(0.5) / (square * T.Sqrt(square)));
            gradient = default;
            gradient.UX = T.Select(isOrigin, T.Zero, scale * angle.X);
            gradient.UZ = T.Select(isOrigin, T.Zero, scale * angle.Z);
            gradient.VX = -x * y * slope;
            gradient.VY = flat * slope;
            gradient.VZ = -z * y * slope;
        }
    }
}
