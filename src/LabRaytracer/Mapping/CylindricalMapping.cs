using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The side of the cylinder of radius 1 around +Y, y in [-1, 1], unrolled onto the picture (Polish: mapowanie cylindryczne).</summary>
/// <remarks>
/// <para>phi = atan2(x, z) in [0, 2 pi), u = phi / 2 pi, v = (y + 1) / 2: lab sheet IV, section 1.1.2, with the two-argument
/// arctangent of its Program 2 instead of atan(x / z), which folds opposite sides together.</para>
/// <para>u in [0, 1), 0 on the axis; error at most 1 ulp. v is correctly rounded, in [0, 1] for y in [-1, 1].
/// The seam u = 0 is the line x = 0, z &gt; 0. Any finite radius gives the same result.</para>
/// <para>The gradient of u is (z, 0, -x) / (2 pi rho²), continuous across the seam; rho below 2^-20 counts as 2^-20, so that its length is at most 2^20 / 2 pi.</para>
/// <list type="table">
/// <listheader><term>local point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>(0, 0, 1)</term><description>(0, 0.5)</description></item>
/// <item><term>(1, -1, 0)</term><description>(0.25, 0)</description></item>
/// <item><term>(0, 1, -1)</term><description>(0.5, 1)</description></item>
/// <item><term>(-1, 0.5, 0)</term><description>(0.75, 0.75)</description></item>
/// <item><term>(1, 0, 1)</term><description>(0.125, 0.5)</description></item>
/// <item><term>(0, 0, 0)</term><description>(0, 0.5)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class CylindricalMapping : IWideMapping
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

    internal readonly struct Formula : IPointFormula
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static (T U, T V) Coordinates<T>(T x, T y, T z)
            where T : unmanaged, IReal<T> =>
            (Elementary.Atan2Turns(x, z), (y + T.Of(1)) * T.Of(0.5));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Gradient<T>(T x, T y, T z, out GradientLanes<T> gradient)
            where T : unmanaged, IReal<T>
        {
            gradient = default;
            AngleGradient<T> angle = new(x, z);
            gradient.UX = angle.X;
            gradient.UZ = angle.Z;
            gradient.VY = T.Of(0.5);
        }
    }
}
