using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The upper half of the sphere around the origin on the whole picture; the lower half shows the bottom edge.</summary>
/// <remarks>
/// <para>u = phi / 2 pi with phi = atan2(x, z), v = 1 - theta / (pi / 2) with theta = atan2(sqrt(x² + z²), y), 0 for y below 0: a sky dome.</para>
/// <para>u in [0, 1), v in [0, 1]; u within 1 ulp, v within 2 (6 below 1e-300, where it is four times a rounded
/// subnormal number). u = 0 on the axis, (0, 0) at the origin. The length of (x, y, z) does not matter. The seam u = 0 is the half
/// meridian x = 0, z &gt; 0. A picture of aspect 4:1 fits.</para>
/// <para>The gradients are those of <see cref="SphericalMapping"/>, that of v doubled on the upper half and 0 below.</para>
/// <list type="table">
/// <listheader><term>local point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>(0, 1, 0)</term><description>(0, 1)</description></item>
/// <item><term>(0, 0, 1)</term><description>(0, 0)</description></item>
/// <item><term>(1, 1, 0)</term><description>(0.25, 0.5)</description></item>
/// <item><term>(0, 2, -2)</term><description>(0.5, 0.5)</description></item>
/// <item><term>(-1, 0, 0)</term><description>(0.75, 0)</description></item>
/// <item><term>(0, -1, 0)</term><description>(0, 0)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class HemisphericalMapping : IWideMapping
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
            T height = T.Select(T.Less(T.Zero, y), y, T.Zero);
            T radius = Elementary.Hypotenuse(Elementary.Finite(x), Elementary.Finite(z));
            return (Elementary.Atan2Turns(x, z), T.Of(4) * Elementary.Atan2Turns(height, radius));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Gradient<T>(T x, T y, T z, out GradientLanes<T> gradient)
            where T : unmanaged, IReal<T>
        {
            T scale = Elementary.GradientScale(Elementary.ToUnitBox(ref x, ref y, ref z));
            AngleGradient<T> angle = new(x, z);
            T distance = T.Fma(x, angle.Sin, z * angle.Cos);
            T square = T.Fma(y, y, distance * distance);
            T isUpper = T.Less(T.Zero, y);
            T slope = isUpper & (scale * T.Of(0.6366197723675814) / T.Select(isUpper, square, T.Of(1)));
            T isOrigin = T.Equal(square, T.Zero);
            gradient = default;
            gradient.UX = T.Select(isOrigin, T.Zero, scale * angle.X);
            gradient.UZ = T.Select(isOrigin, T.Zero, scale * angle.Z);
            gradient.VX = -y * angle.Sin * slope;
            gradient.VY = distance * slope;
            gradient.VZ = -y * angle.Cos * slope;
        }
    }
}
