using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A slide projector (camera mapping): every point shows what lies on the line to the projector's eye in its picture.</summary>
/// <remarks>
/// <para>With f, r and up the unit axes of the projector, q = p - eye and d = f . q: u = 1/2 + r . q / (2 d a tan(fov / 2)), v = 1/2 + up . q / (2 d tan(fov / 2)), fov the vertical
/// angle and a the aspect. The picture covers [0, 1] x [0, 1]; points behind the eye or in its plane get (-1, -1), outside of it.</para>
/// <para>u and v stay within 1e9 of 0. Outside [0, 1] the wrap decides; by default the border: nothing. The slide shines through: nothing shadows it.</para>
/// <para>The table is for the eye (0, 0, 2), the target (0, 0, 0), 90 degrees and the aspect 1.</para>
/// <list type="table">
/// <listheader><term>point (x, y, z)</term><description>(u, v)</description></listheader>
/// <item><term>(0, 0, 0)</term><description>(0.5, 0.5)</description></item>
/// <item><term>(1, 1, 1)</term><description>(1, 1)</description></item>
/// <item><term>(-1, -1, 1)</term><description>(0, 0)</description></item>
/// <item><term>(1, 0, 0)</term><description>(0.75, 0.5)</description></item>
/// <item><term>(0, 4, 0)</term><description>(0.5, 1.5)</description></item>
/// <item><term>(0, 0, 3)</term><description>(-1, -1)</description></item>
/// </list>
/// <para>Immutable, thread safe.</para>
/// </remarks>
public sealed class ProjectorMapping : IWideMapping
{
    private const double Farthest = 1e9;

    private readonly Vector3D _forward;
    private readonly Vector3D _right;
    private readonly Vector3D _up;

    /// <summary>A projector.</summary>
    /// <param name="eye">Where it stands; finite.</param>
    /// <param name="target">The point in the middle of its picture; finite, not the eye.</param>
    /// <param name="up">What is up in its picture; finite, not along the line from the eye to the target. Null (default): +Y.</param>
    /// <param name="fieldOfViewDegrees">Vertical angle of its picture, degrees, (0, 180). Default: 40.</param>
    /// <param name="aspect">Width of its picture over its height; finite, above 0. Default: 1.</param>
    /// <param name="frame">The space of eye, target and up: the object's local space, or the world. Default: the object.</param>
    /// <exception cref="ArgumentException">Eye, target and up give no frame.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The angle, the aspect or the frame is out of range.</exception>
    public ProjectorMapping(
        Point3D eye, Point3D target, Vector3D? up = null, double fieldOfViewDegrees = 40, double aspect = 1, TextureFrame frame = TextureFrame.Object)
    {
        Vector3D upward = up ?? Vector3D.UnitY, line = target - eye;
        Vector3D across = line.IsFinite && upward.IsFinite ? Vector3D.Cross(line, upward) : Vector3D.Zero;
        if (!(across.Length > 1e-12 * line.Length * upward.Length))
        {
            throw new ArgumentException("A projector needs a finite eye, another finite target, and an up direction that does not lie along the line between them.", nameof(target));
        }

        FieldOfViewDegrees = fieldOfViewDegrees is > 0 and < 180
            ? fieldOfViewDegrees
            : throw new ArgumentOutOfRangeException(nameof(fieldOfViewDegrees), fieldOfViewDegrees, "The field of view of a projector must be above 0 and below 180 degrees.");
        (Eye, Target, Up, Frame) = (eye, target, upward, PropertyChecks.Known(frame));
        Aspect = PropertyChecks.Positive(aspect, "aspect of a projector");
        double tan = Elementary.TanDegrees(fieldOfViewDegrees / 2);
        _forward = line.Normalized();
        Vector3D right = across.Normalized();
        _right = right / (2 * tan * aspect);
        _up = Vector3D.Cross(right, _forward).Normalized() / (2 * tan);
    }

    /// <summary>Where the projector stands.</summary>
    public Point3D Eye { get; }

    /// <summary>The point in the middle of its picture.</summary>
    public Point3D Target { get; }

    /// <summary>What is up in its picture.</summary>
    public Vector3D Up { get; }

    /// <summary>Vertical angle of its picture, degrees.</summary>
    public double FieldOfViewDegrees { get; }

    /// <summary>Width of its picture over its height.</summary>
    public double Aspect { get; }

    /// <summary>The space the projector stands in; its gradient is one of this space.</summary>
    public TextureFrame Frame { get; }

    /// <summary>Border: there is nothing beside the slide.</summary>
    public TextureWrap DefaultWrapU => TextureWrap.Border;

    /// <summary>Border: there is nothing above and below the slide.</summary>
    public TextureWrap DefaultWrapV => TextureWrap.Border;

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public TextureCoordinate Map(in SurfacePosition position)
    {
        Point3D p = Place(position);
        (Double1 u, Double1 v) = Coordinates<Double1>(new(p.X), new(p.Y), new(p.Z));
        return new TextureCoordinate(u.Value, v.Value);
    }

    /// <inheritdoc/>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public MappingGradient Gradient(in SurfacePosition position)
    {
        Point3D p = Place(position);
        Slopes<Double1>(new(p.X), new(p.Y), new(p.Z), out GradientLanes<Double1> gradient);
        return PointFormulas.Of(gradient);
    }

    unsafe void IWideMapping.Map<R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets)
    {
        bool isWorld = Frame == TextureFrame.World;
        R* x = isWorld ? positions.WorldX : positions.X, y = isWorld ? positions.WorldY : positions.Y, z = isWorld ? positions.WorldZ : positions.Z;
        for (int i = 0; i < packets; i++)
        {
            (coordinates.U[i], coordinates.V[i]) = Coordinates(x[i], y[i], z[i]);
        }
    }

    unsafe void IWideMapping.Gradients<T>(in PositionBatch<T> positions, in GradientBatch<T> gradients, int packets)
    {
        bool isWorld = Frame == TextureFrame.World;
        T* x = isWorld ? positions.WorldX : positions.X, y = isWorld ? positions.WorldY : positions.Y, z = isWorld ? positions.WorldZ : positions.Z;
        for (int i = 0; i < packets; i++)
        {
            Slopes(x[i], y[i], z[i], out GradientLanes<T> gradient);
            gradients.Store(i, gradient);
        }
    }

    private Point3D Place(in SurfacePosition position) => Frame == TextureFrame.World ? position.WorldPoint : position.LocalPoint;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private (T U, T V) Coordinates<T>(T x, T y, T z)
        where T : unmanaged, IReal<T>
    {
        T isAhead = Locate(x, y, z, out T depth, out T right, out T up);
        T far = T.Of(Farthest), half = T.Of(0.5), none = T.Of(-1);
        T u = T.Max(T.Min((right / depth) + half, far), -far), v = T.Max(T.Min((up / depth) + half, far), -far);
        return (T.Select(isAhead, u, none), T.Select(isAhead, v, none));
    }

    /// <summary>Depth, and the products with the scaled axes; mask of points ahead.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private T Locate<T>(T x, T y, T z, out T depth, out T right, out T up)
        where T : unmanaged, IReal<T>
    {
        // A point as far as numbers reach must not overflow on the way.
        T most = T.Of(T.IsSingle ? 1e30 : 1e300);
        x = T.Max(T.Min(Elementary.Finite(x), most), -most) - T.Of(Eye.X);
        y = T.Max(T.Min(Elementary.Finite(y), most), -most) - T.Of(Eye.Y);
        z = T.Max(T.Min(Elementary.Finite(z), most), -most) - T.Of(Eye.Z);
        depth = Along(_forward, x, y, z);
        right = Along(_right, x, y, z);
        up = Along(_up, x, y, z);
        return T.Less(T.Zero, depth);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Along<T>(Vector3D axis, T x, T y, T z)
        where T : unmanaged, IReal<T> => Lane.Dot(x, y, z, T.Of(axis.X), T.Of(axis.Y), T.Of(axis.Z));

    /// <summary>(axis - (axis . q / d) f) / d: the quotient rule. 0 behind the eye, where nothing changes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Slopes<T>(T x, T y, T z, out GradientLanes<T> gradient)
        where T : unmanaged, IReal<T>
    {
        gradient = default;

        // Nearer than 2^-20 the slope is that at 2^-20.
        T isAhead = Locate(x, y, z, out T depth, out T right, out T up);
        T inverse = isAhead & (T.Of(1) / T.Max(depth, T.Of(1.0 / (1 << 20))));
        T far = T.Of(Farthest);
        T u = T.Max(T.Min(right * inverse, far), -far), v = T.Max(T.Min(up * inverse, far), -far);
        gradient.UX = (T.Of(_right.X) - (u * T.Of(_forward.X))) * inverse;
        gradient.UY = (T.Of(_right.Y) - (u * T.Of(_forward.Y))) * inverse;
        gradient.UZ = (T.Of(_right.Z) - (u * T.Of(_forward.Z))) * inverse;
        gradient.VX = (T.Of(_up.X) - (v * T.Of(_forward.X))) * inverse;
        gradient.VY = (T.Of(_up.Y) - (v * T.Of(_forward.Y))) * inverse;
        gradient.VZ = (T.Of(_up.Z) - (v * T.Of(_forward.Z))) * inverse;
    }
}
