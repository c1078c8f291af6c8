using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A gradient of colours (Polish: gradient): stops along u, v, an axis or a radius, interpolated in linear light.</summary>
/// <remarks>t = u, v, axis . p or |p - center|, with p the local point; the ramp makes colours of t: stops may lie anywhere. Immutable, thread safe.</remarks>
public sealed class GradientTexture : IPreparedTexture
{
    private readonly Vector3D _axis = Vector3D.UnitY;
    private readonly Point3D _center = Point3D.Origin;

    /// <summary>What the gradient runs along. Default: u.</summary>
    public GradientKind Kind { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Direction of a gradient along an axis, object space; its length scales t; finite. Default: +Y.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not finite.</exception>
    public Vector3D Axis
    {
        get => _axis;
        init => _axis = value.IsFinite ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The axis of a gradient needs finite components.");
    }

    /// <summary>The point that a radial gradient starts from, object space; finite. Default: the origin.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not finite.</exception>
    public Point3D Center
    {
        get => _center;
        init => _center = value.IsFinite ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "The center of a gradient needs finite coordinates.");
    }

    /// <summary>The colours. Default: black at 0 to white at 1.</summary>
    public ColorRamp Ramp { get; init => field = PropertyChecks.NotNull(value); } = ColorRamp.Grey;

    /// <inheritdoc/>
    public TextureNeeds Needs => PatternSampler.Needs(Space, 0);

    private PatternSpace Space => Kind is GradientKind.U or GradientKind.V ? PatternSpace.Uv : PatternSpace.Local;

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => PatternSampler.Sample(new Pattern(this), Space, 0, Ramp, lookup);

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => new PatternSampler<Pattern>(new Pattern(this), Space, 0, Ramp);

    private readonly struct Pattern(GradientTexture texture) : IPattern
    {
        [MethodImpl(MethodImplOptions.NoInlining)]
        public F At<R, F, I>(in PatternPoint<R, F> point, out F kept)
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            kept = F.Of(1);
            switch (texture.Kind)
            {
                case GradientKind.U:
                    return R.ToSingle(point.X);
                case GradientKind.V:
                    return R.ToSingle(point.Y);
                case GradientKind.Axis:
                    Vector3D axis = texture.Axis;
                    return R.ToSingle(Lane.Dot(point.X, point.Y, point.Z, R.Of(axis.X), R.Of(axis.Y), R.Of(axis.Z)));
                default:
                    Point3D center = texture.Center;
                    R x = point.X - R.Of(center.X), y = point.Y - R.Of(center.Y), z = point.Z - R.Of(center.Z);
                    return R.ToSingle(Elementary.Hypotenuse(Elementary.Hypotenuse(x, y), z));
            }
        }
    }
}
