using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The square [-1, 1] x [-1, 1] of the plane y = 0, unrolled onto the picture (Polish: mapowanie prostokątne).</summary>
/// <remarks>
/// <para>u = (z + 1) / 2, v = (x + 1) / 2: lab sheet IV, section 1.1.1, with the sign of v corrected: the printed (x - 1) / 2 lies in [-1, 0].</para>
/// <para>Both are correctly rounded. The square gives [0, 1] with both ends; points outside of it go on linearly, for wrapping.
/// Seen from +Y the picture is not mirrored.</para>
/// <list type="table">
/// <listheader><term>local point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>(0, 0, 0)</term><description>(0.5, 0.5)</description></item>
/// <item><term>(-1, 0, -1)</term><description>(0, 0)</description></item>
/// <item><term>(1, 0, -1)</term><description>(0, 1)</description></item>
/// <item><term>(-1, 0, 1)</term><description>(1, 0)</description></item>
/// <item><term>(1, 0, 1)</term><description>(1, 1)</description></item>
/// <item><term>(0.5, 0, -0.5)</term><description>(0.25, 0.75)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class RectangularMapping : IWideMapping
{
    /// <summary>Texture coordinates of a point.</summary>
    /// <param name="localPoint">The point in object space; finite.</param>
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
            where T : unmanaged, IReal<T>
        {
            T half = T.Of(0.5);
            return ((z + T.Of(1)) * half, (x + T.Of(1)) * half);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static void Gradient<T>(T x, T y, T z, out GradientLanes<T> gradient)
            where T : unmanaged, IReal<T>
        {
            gradient = default;
            gradient.UZ = gradient.VX = T.Of(0.5);
        }
    }
}
