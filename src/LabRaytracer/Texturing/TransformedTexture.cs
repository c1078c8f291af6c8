namespace LabRaytracer;

/// <summary>A texture moved, turned and scaled: through the object's volume, and over texture space.</summary>
/// <remarks>
/// <para>The source is looked up at the point T⁻¹ p, with T the transform: scale 2 makes the pattern twice as large. The inverse is found once. (u, v) go through
/// <see cref="Uv"/> after the transform of the slot. Footprints are transformed too.</para>
/// <para>With <see cref="Frame"/> = world, p is the point in world space instead of the object's own. Immutable, thread safe if the source is.</para>
/// </remarks>
public sealed class TransformedTexture : IPreparedTexture
{
    /// <summary>A transformed texture.</summary>
    /// <param name="source">The texture.</param>
    /// <param name="transform">From the texture's space to the object's (or the world's). Default: none.</param>
    /// <exception cref="ArgumentNullException">The source is missing.</exception>
    public TransformedTexture(ITexture source, Transform? transform = null)
    {
        Source = PropertyChecks.NotNull(source);
        Transform = transform ?? Transform.Identity;
    }

    /// <summary>The texture.</summary>
    public ITexture Source { get; }

    /// <summary>From the texture's space to the object's (or the world's).</summary>
    public Transform Transform { get; }

    /// <summary>What the texture is fixed to. Default: the object.</summary>
    public TextureFrame Frame { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Transform of (u, v), after that of the slot. Default: none.</summary>
    public UvTransform Uv { get; init => field = PropertyChecks.NotNull(value); } = UvTransform.Identity;

    /// <inheritdoc/>
    public TextureNeeds Needs
    {
        get
        {
            TextureNeeds needs = Source.Needs;
            return Frame == TextureFrame.Object || (needs & TextureNeeds.LocalPoint) == 0 ? needs : (needs & ~TextureNeeds.LocalPoint) | TextureNeeds.WorldPoint;
        }
    }

    private bool MovesPoints => (Source.Needs & TextureNeeds.LocalPoint) != 0 && (Frame == TextureFrame.World || !Transform.IsIdentity);

    private bool MovesCoordinates => (Source.Needs & TextureNeeds.Coordinate) != 0 && !Uv.IsIdentity;

    /// <inheritdoc/>
    public bool HasAlpha => Source.HasAlpha;

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => Source.Sample(Moved(lookup));

    /// <inheritdoc/>
    public float Alpha(in TextureLookup lookup) => Source.Alpha(Moved(lookup));

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter)
    {
        TextureSampler source = TextureParts.Prepare(Source, use, filter);
        return MovesPoints || MovesCoordinates ? new TransformedSampler(this, source, MovesPoints, MovesCoordinates) : source;
    }

    /// <summary>Where the source is looked up.</summary>
    private TextureLookup Moved(in TextureLookup lookup)
    {
        TextureLookup moved = lookup;
        if (MovesCoordinates)
        {
            (Float1 ux, Float1 vx) = Uv.ApplyToStep(Single(lookup.Footprint.DuDx), Single(lookup.Footprint.DvDx));
            (Float1 uy, Float1 vy) = Uv.ApplyToStep(Single(lookup.Footprint.DuDy), Single(lookup.Footprint.DvDy));
            moved = moved with { Coordinate = Uv.Apply(lookup.Coordinate), Footprint = new(ux.Value, vx.Value, uy.Value, vy.Value) };
        }

        if (MovesPoints)
        {
            bool isWorld = Frame == TextureFrame.World;
            Vector3D normal = isWorld ? lookup.WorldNormal : lookup.LocalNormal;
            SurfaceFootprint footprint = isWorld ? lookup.WorldFootprint : lookup.LocalFootprint;
            Double1 x = new(normal.X), y = new(normal.Y), z = new(normal.Z);
            Affine.Normal(Transform.WorldFromObjectRows, ref x, ref y, ref z);
            moved = moved with
            {
                LocalPoint = Transform.ObjectFromWorld(isWorld ? lookup.WorldPoint : lookup.LocalPoint),
                LocalNormal = new Vector3D(x.Value, y.Value, z.Value),
                LocalFootprint = new SurfaceFootprint(Step(footprint.DpDx), Step(footprint.DpDy)),
            };
        }

        return moved;
    }

    private static Float1 Single(double number) => new((float)number);

    /// <summary>A transformed step of a footprint, in floats as in the columns.</summary>
    private Vector3D Step(Vector3D step)
    {
        Float1 x = Single(step.X), y = Single(step.Y), z = Single(step.Z);
        Affine.Step(Transform.ObjectFromWorldRows, ref x, ref y, ref z);
        return new Vector3D(x.Value, y.Value, z.Value);
    }
}
