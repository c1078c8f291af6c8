using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>All directions on one disk (angular map, light probe): the angle from the axis is the distance from the middle of the picture.</summary>
/// <remarks>
/// <para>u = (1 + r x / rho) / 2, v = (1 + r y / rho) / 2 with rho = sqrt(x² + y²) and r = atan2(rho, z) / pi, or atan2(rho, -z) / pi where the probe faces -Z.</para>
/// <para>u and v in [0, 1], off by at most 4 units of 2^-53. The corners of the picture outside of the inscribed circle are never shown. The direction in the middle and the
/// origin give (0.5, 0.5); the opposite direction, which is the whole rim, gives (1, 0.5). The length of (x, y, z) does not matter.</para>
/// <para>The gradient has length 1 / (2 pi) at distance 1 in the middle and grows towards the rim; rho below 2^-20 of the largest coordinate counts as that, where it would
/// grow without end.</para>
/// <list type="table">
/// <listheader><term>local point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>(0, 0, 1)</term><description>(0.5, 0.5)</description></item>
/// <item><term>(1, 0, 0)</term><description>(0.75, 0.5)</description></item>
/// <item><term>(0, -1, 0)</term><description>(0.5, 0.25)</description></item>
/// <item><term>(-1, 0, 1)</term><description>(0.375, 0.5)</description></item>
/// <item><term>(0, 1, -1)</term><description>(0.5, 0.875)</description></item>
/// <item><term>(0, 0, -1)</term><description>(1, 0.5)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class LightProbeMapping : IWideMapping
{
    /// <summary>Clamp: the picture does not repeat.</summary>
    public TextureWrap DefaultWrapU => TextureWrap.Clamp;

    /// <summary>Clamp: the picture does not repeat.</summary>
    public TextureWrap DefaultWrapV => TextureWrap.Clamp;

    /// <summary>The direction in the middle of the picture. Default: +Z.</summary>
    public LightProbeFacing Facing { get; init => field = PropertyChecks.Known(value); }

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
        // Around the axis x and y count, however small beside z: next to the rim they decide which part of it is seen.
        T across = Elementary.Finite(x), along = Elementary.Finite(y), half = T.Of(0.5), one = T.Of(1);
        T larger = T.Max(T.Abs(across), T.Abs(along)), isAxis = T.Equal(larger, T.Zero);
        larger = T.Select(isAxis, one, larger);
        (across, along) = (across / larger, along / larger);
        T radius = T.Sqrt(T.Fma(across, across, along * along));
        T cos = T.Select(isAxis, one, across / radius), sin = T.Select(isAxis, T.Zero, along / radius);

        Elementary.ToUnitBox(ref x, ref y, ref z);
        T turns = Elementary.Atan2Turns(Elementary.Hypotenuse(x, y), Facing == LightProbeFacing.PositiveZ ? z : -z);
        return (T.Min(T.Max(T.Fma(turns, cos, half), T.Zero), one), T.Min(T.Max(T.Fma(turns, sin, half), T.Zero), one));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Slopes<T>(T x, T y, T z, out GradientLanes<T> gradient)
        where T : unmanaged, IReal<T>
    {
        T scale = Elementary.GradientScale(Elementary.ToUnitBox(ref x, ref y, ref z));
        z = Facing == LightProbeFacing.PositiveZ ? z : -z;
        T distance = T.Sqrt(T.Fma(x, x, y * y)), square = T.Fma(z, z, distance * distance);
        T isOrigin = T.Equal(square, T.Zero), isAxis = T.Equal(distance, T.Zero);
        T cos = T.Select(isAxis, T.Of(1), x / distance), sin = T.Select(isAxis, T.Zero, y / distance);

        // r / 2 = turns grows by k along rho, by the first term along z; around the axis it is spread over the circle.
        T outward = T.Of(0.15915494309189535) * scale / T.Select(isOrigin, T.Of(1), square);
        T along = z * outward;
        T least = T.Of(AngleGradient<T>.LeastDistance);
        T around = scale * Elementary.Atan2Turns(distance, z) / T.Max(distance, least);
        around = T.Select(T.Less(distance, least) & T.Less(T.Zero, z), along, around);
        T depth = (Facing == LightProbeFacing.PositiveZ ? -distance : distance) * outward;
        T mixed = cos * sin * (along - around);
        gradient.UX = Kept(isOrigin, T.Fma(along * cos, cos, around * sin * sin));
        gradient.UY = Kept(isOrigin, mixed);
        gradient.UZ = Kept(isOrigin, depth * cos);
        gradient.VX = Kept(isOrigin, mixed);
        gradient.VY = Kept(isOrigin, T.Fma(along * sin, sin, around * cos * cos));
        gradient.VZ = Kept(isOrigin, depth * sin);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Kept<T>(T isOrigin, T number)
        where T : unmanaged, IReal<T> => T.Select(isOrigin, T.Zero, number);
}
