using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The disk of radius 1 in the plane y = 0, by angle and distance from the centre.</summary>
/// <remarks>
/// <para>u = phi / 2 pi with phi = atan2(x, z), v = rho with rho = sqrt(x² + z²).</para>
/// <para>u in [0, 1), 0 at the centre; error at most 1 ulp. v in [0, 1] on the disk, error at most 1 ulp.
/// The centre is the bottom edge of the picture, the rim its top edge; seen from -Y the picture is not mirrored.</para>
/// <para>The gradient of u is (z, 0, -x) / (2 pi rho²), continuous across the seam; rho below 2^-20 counts as 2^-20, so that its length is at most 2^20 / 2 pi. That of v is (x, 0, z) / rho.</para>
/// <list type="table">
/// <listheader><term>local point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>(0, 0, 0)</term><description>(0, 0)</description></item>
/// <item><term>(0, 0, 1)</term><description>(0, 1)</description></item>
/// <item><term>(1, 0, 0)</term><description>(0.25, 1)</description></item>
/// <item><term>(0, 0, -0.5)</term><description>(0.5, 0.5)</description></item>
/// <item><term>(-0.25, 0, 0)</term><description>(0.75, 0.25)</description></item>
/// <item><term>(0.375, 0, 0.5)</term><description>(0.10241638234956672, 0.625)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class DiskMapping : IWideMapping
{
    /// <summary>u runs around the axis.</summary>
    public bool ClosesU => true;

    /// <summary>Clamp: the picture ends at both ends of v.</summary>
    public TextureWrap DefaultWrapV => TextureWrap.Clamp;

    /// <summary>Texture coordinates of a point.</summary>
    /// <param name="localPoint">The point in object space. For the angles NaN counts as 0 and infinity as the largest number: they stay in range.</param>
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
            where T : unmanaged, IReal<T> => (Elementary.Atan2Turns(x, z), Elementary.Hypotenuse(x, z));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Gradient<T>(T x, T y, T z, out GradientLanes<T> gradient)
            where T : unmanaged, IReal<T>
        {
            gradient = default;
            AngleGradient<T> angle = new(x, z);
            gradient.UX = angle.X;
            gradient.UZ = angle.Z;
            gradient.VX = angle.Sin;
            gradient.VZ = angle.Cos;
        }
    }
}
