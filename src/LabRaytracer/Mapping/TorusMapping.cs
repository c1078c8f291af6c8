using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The torus around +Y whose ring has radius 1, by the angles around the ring and around the tube.</summary>
/// <remarks>
/// <para>u = phi / 2 pi with phi = atan2(x, z); v = psi / 2 pi with psi = atan2(y, rho - R), rho = sqrt(x² + z²), R the radius of the ring: 0 on the outer equator, 1/4 on top,
/// 1/2 on the inner equator, 3/4 at the bottom.</para>
/// <para>u and v in [0, 1). u within 1 ulp; the difference rho - R, and with it the angle psi, is off by at most 2 units of 2^-53 times R over the tube's radius.
/// (0, v) on the axis, v = 0 on the ring itself. Seams: u = 0 on the half plane x = 0, z &gt; 0, v = 0 on the outer equator.</para>
/// <para>The gradients are (z, 0, -x) / (2 pi rho²) and (-y x / rho, rho - R, -y z / rho) / (2 pi r²) with r the distance from the ring; continuous across the seams;
/// rho and r below 2^-20 count as 2^-20.</para>
/// <list type="table">
/// <listheader><term>local point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>(0, 0, 1.5)</term><description>(0, 0)</description></item>
/// <item><term>(1, 0.5, 0)</term><description>(0.25, 0.25)</description></item>
/// <item><term>(0, 0, -0.5)</term><description>(0.5, 0.5)</description></item>
/// <item><term>(-1, -0.25, 0)</term><description>(0.75, 0.75)</description></item>
/// <item><term>(0, 0.25, 1.25)</term><description>(0, 0.125)</description></item>
/// <item><term>(0, 0, 0)</term><description>(0, 0.5)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class TorusMapping : IWideMapping
{
    /// <summary>The mapping of a torus.</summary>
    /// <param name="ringRadius">Radius of the ring, local units; finite, above 0. Default: 1, that of the local form of the torus shape.</param>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public TorusMapping(double ringRadius = 1) => RingRadius = PropertyChecks.Positive(ringRadius, "ring radius of a torus mapping");

    /// <summary>Radius of the ring, local units.</summary>
    public double RingRadius { get; }

    /// <summary>u runs around the axis.</summary>
    public bool ClosesU => true;

    /// <summary>v runs around the tube.</summary>
    public bool ClosesV => true;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public TextureCoordinate Map(in SurfacePosition position)
    {
        Point3D p = position.LocalPoint;
        (Double1 u, Double1 v) = Coordinates<Double1>(new(p.X), new(p.Y), new(p.Z));
        return new TextureCoordinate(u.Value, v.Value);
    }

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public MappingGradient Gradient(in SurfacePosition position)
    {
        Point3D p = position.LocalPoint;
        Slopes<Double1>(new(p.X), new(p.Y), new(p.Z), out GradientLanes<Double1> gradient);
        return PointFormulas.Of(gradient);
    }

    unsafe void IWideMapping.Map<R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets)
    {
        for (int i = 0; i < packets; i++)
        {
            (coordinates.U[i], coordinates.V[i]) = Coordinates(positions.X[i], positions.Y[i], positions.Z[i]);
        }
    }

    unsafe void IWideMapping.Gradients<T>(in PositionBatch<T> positions, in GradientBatch<T> gradients, int packets)
    {
        for (int i = 0; i < packets; i++)
        {
            Slopes(positions.X[i], positions.Y[i], positions.Z[i], out GradientLanes<T> gradient);
            gradients.Store(i, gradient);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private (T U, T V) Coordinates<T>(T x, T y, T z)
        where T : unmanaged, IReal<T>
    {
        T outward = Elementary.Hypotenuse(Elementary.Finite(x), Elementary.Finite(z)) - T.Of(RingRadius);
        return (Elementary.Atan2Turns(x, z), Elementary.Atan2Turns(y, outward));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Slopes<T>(T x, T y, T z, out GradientLanes<T> gradient)
        where T : unmanaged, IReal<T>
    {
        (x, y, z) = (Elementary.Finite(x), Elementary.Finite(y), Elementary.Finite(z));
        AngleGradient<T> around = new(x, z);
        AngleGradient<T> tube = new(y, Elementary.Finite(Elementary.Hypotenuse(x, z)) - T.Of(RingRadius));
        gradient = default;
        gradient.UX = around.X;
        gradient.UZ = around.Z;
        gradient.VX = tube.Z * around.Sin;
        gradient.VY = tube.X;
        gradient.VZ = tube.Z * around.Cos;
    }
}
