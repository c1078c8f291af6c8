namespace LabRaytracer;

/// <summary>A texture projected along the three axes and blended by the normal: for shapes that no mapping unrolls.</summary>
/// <remarks>
/// <para>color = w_x T(u_x, v_x) + w_y T(u_y, v_y) + w_z T(u_z, v_z) with w_i = |n_i|^k / (|n_x|^k + |n_y|^k + |n_z|^k), n the local normal and k the sharpness.
/// (u, v) of an axis are those of <see cref="BoxMapping"/> on the face that the normal looks at, times the scale around the face's middle; none is mirrored.</para>
/// <para>A projection that no point of a group sees (weight 0, as on the flat sides of a box) is not looked up. The mapping of the slot is not used.</para>
/// <para>Immutable, thread safe if the source is.</para>
/// </remarks>
public sealed class TriplanarTexture : IPreparedTexture
{
    private readonly int _sharpness = 4;
    private readonly double _scale = 1;

    /// <summary>A projected texture.</summary>
    /// <param name="source">The texture.</param>
    /// <exception cref="ArgumentNullException">The source is missing.</exception>
    public TriplanarTexture(ITexture source) => Source = PropertyChecks.NotNull(source);

    /// <summary>The texture.</summary>
    public ITexture Source { get; }

    /// <summary>How sharply one projection gives way to the next: the exponent k, [1, 64]. Default: 4.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [1, 64].</exception>
    public int Sharpness
    {
        get => _sharpness;
        init => _sharpness = value is >= 1 and <= 64
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The sharpness of a triplanar texture must be in [1, 64].");
    }

    /// <summary>How often the texture is repeated over the cube [-1, 1]³; above 0, finite. Default: 1.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Not a finite number above 0.</exception>
    public double Scale
    {
        get => _scale;
        init => _scale = PropertyChecks.Positive(value, "scale of a triplanar texture");
    }

    /// <inheritdoc/>
    public TextureNeeds Needs => Source.Needs == TextureNeeds.None ? TextureNeeds.None : (Source.Needs & ~TextureNeeds.Coordinate) | TextureNeeds.LocalPoint;

    /// <inheritdoc/>
    public bool HasAlpha => Source.HasAlpha;

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => Sum(lookup, Source.Sample);

    /// <inheritdoc/>
    public float Alpha(in TextureLookup lookup) => Sum(lookup, (in TextureLookup projected) => Intensity.Grey(Source.Alpha(projected))).R;

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) => new TriplanarSampler(this, TextureParts.Prepare(Source, use, filter));

    /// <summary>The weighted sum over the projections.</summary>
    private Intensity Sum(in TextureLookup lookup, Reader read)
    {
        Point3D p = lookup.LocalPoint;
        Vector3D n = lookup.LocalNormal;
        TriplanarPlanes<Double1, Float1, Int1> planes = new(this, new(p.X), new(p.Y), new(p.Z), new(n.X), new(n.Y), new(n.Z));
        Float1 red = Float1.Zero, green = Float1.Zero, blue = Float1.Zero;
        for (int axis = 0; axis < 3; axis++)
        {
            Float1 weight = planes.Weight(axis);
            if (weight.Value > 0)
            {
                (Double1 u, Double1 v) = planes.Coordinates(axis);
                Intensity color = read(lookup with
                {
                    Coordinate = new(u.Value, v.Value),
                    Footprint = Footprint(lookup, planes, axis),
                    WrapU = TextureWrap.Repeat,
                    WrapV = TextureWrap.Repeat,
                });
                red = Float1.Fma(weight, new(color.R), red);
                green = Float1.Fma(weight, new(color.G), green);
                blue = Float1.Fma(weight, new(color.B), blue);
            }
        }

        return new Intensity(red.Value, green.Value, blue.Value);
    }

    private static TextureFootprint Footprint(in TextureLookup lookup, in TriplanarPlanes<Double1, Float1, Int1> planes, int axis)
    {
        static Float1 Single(double number) => new((float)number);
        Vector3D right = lookup.LocalFootprint.DpDx, down = lookup.LocalFootprint.DpDy;
        (Float1 ux, Float1 vx) = planes.Step(axis, Single(right.X), Single(right.Y), Single(right.Z));
        (Float1 uy, Float1 vy) = planes.Step(axis, Single(down.X), Single(down.Y), Single(down.Z));
        return new TextureFootprint(ux.Value, vx.Value, uy.Value, vy.Value);
    }

    private delegate Intensity Reader(in TextureLookup lookup);
}
