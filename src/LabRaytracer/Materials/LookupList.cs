namespace LabRaytracer;

/// <summary>The textures and mappings that some slots read: each once, in the order in which they are computed.</summary>
/// <param name="defaultMapping">Mapping of slots that do not name one.</param>
/// <param name="textures">Makes textures ready.</param>
internal sealed class LookupList(IMapping defaultMapping, TexturePreparation textures)
{
    private readonly List<(ITexture Texture, TextureUse Use, int Coordinates)> _keys = [];
    private readonly List<CompiledLookup> _lookups = [];
    private readonly List<CompiledCoordinates> _coordinates = [];

    /// <summary>Distinct textures.</summary>
    public IReadOnlyList<CompiledLookup> Lookups => _lookups;

    /// <summary>Distinct mappings.</summary>
    public IReadOnlyList<CompiledCoordinates> Coordinates => _coordinates;

    /// <summary>Columns of surface points that mappings and 3D textures read.</summary>
    public SurfaceNeeds Needs
    {
        get
        {
            SurfaceNeeds needs = SurfaceNeeds.None;
            foreach (CompiledLookup lookup in _lookups)
            {
                needs |= (lookup.Needs & TextureNeeds.LocalPoint) != 0 ? SurfaceNeeds.LocalPoint | SurfaceNeeds.LocalNormal : 0;
            }

            foreach (CompiledCoordinates set in _coordinates)
            {
                needs |= set.Mapping switch
                {
                    MeshMapping => SurfaceNeeds.SurfaceCoordinates,
                    IWideMapping wide => SurfaceNeeds.LocalPoint | (wide.NeedsNormal ? SurfaceNeeds.LocalNormal : 0),
                    _ => SurfaceNeeds.LocalPoint | SurfaceNeeds.LocalNormal | SurfaceNeeds.SurfaceCoordinates,
                };
            }

            return needs;
        }
    }

    /// <summary>Tells whether some texture reads footprints.</summary>
    public bool NeedsFootprints
    {
        get
        {
            bool needs = false;
            foreach (CompiledLookup lookup in _lookups)
            {
                needs |= (lookup.Needs & TextureNeeds.Footprint) != 0;
            }

            return needs;
        }
    }

    /// <summary>What must be known of steps on the surface if rays carry differentials.</summary>
    public StepNeeds Steps
    {
        get
        {
            bool hasOwn = false;
            foreach (CompiledCoordinates set in _coordinates)
            {
                hasOwn |= set.Mapping is MeshMapping or not IWideMapping;
            }

            return !NeedsFootprints ? StepNeeds.None : hasOwn ? StepNeeds.Local | StepNeeds.SurfaceGradient : StepNeeds.Local;
        }
    }

    /// <summary>Tells whether some mapping reads world points.</summary>
    public bool ReadsWorld
    {
        get
        {
            bool reads = false;
            foreach (CompiledCoordinates set in _coordinates)
            {
                reads |= set.Mapping.Frame == TextureFrame.World;
            }

            return reads;
        }
    }

    /// <summary>Tells whether some texture reads the footprints of a coordinate set.</summary>
    public bool NeedsFootprint(int set)
    {
        bool needs = false;
        foreach (CompiledLookup lookup in _lookups)
        {
            needs |= lookup.Coordinates == set && (lookup.Needs & TextureNeeds.Footprint) != 0;
        }

        return needs;
    }

    /// <summary>Reduces a colour slot.</summary>
    /// <param name="slot">The slot.</param>
    /// <param name="cutOut">Texture whose alpha cuts the surface out, or null: its colours are weighted by alpha in filters.</param>
    public CompiledSlot Compile(TextureSlot slot, ITexture? cutOut)
    {
        CompiledSlot own = CompileOwn(slot, cutOut);
        CompiledLayer[] layers = [.. slot.Layers.Where(layer => layer.Opacity > 0).Select(Compile)];
        if (layers.Length == 0)
        {
            return own;
        }

        // The layers read lookups that are already there: the stack comes after them.
        int stack = Append(default, new CompiledLookup(null, TextureNeeds.None, -1) { Stack = new LayerStack(own, layers) });
        return new CompiledSlot(Intensity.White, stack, BlendMode.Replace, 1);
    }

    private CompiledSlot CompileOwn(TextureSlot slot, ITexture? cutOut)
    {
        if (slot.Texture is not { } texture || !slot.IsTextured)
        {
            return new CompiledSlot(slot.Value, -1, slot.Blend, 1);
        }

        if (texture.Needs == TextureNeeds.None)
        {
            return new CompiledSlot(slot.Apply(texture.Sample(default)), -1, slot.Blend, 1);
        }

        int lookup = texture == cutOut && texture.HasAlpha
            ? AddWeighted(texture, slot.Mapping, slot.Transform)
            : Add(texture, slot.Mapping, slot.Transform, TextureUse.Color);
        return new CompiledSlot(slot.Value, lookup, slot.Blend, slot.Amount);
    }

    private CompiledLayer Compile(TextureLayer layer)
    {
        ITexture texture = layer.Texture;
        CompiledCoordinates place = layer.IsDecal
            ? CompiledCoordinates.OfDecal(layer.Mapping ?? defaultMapping, layer.Transform)
            : new CompiledCoordinates(layer.Mapping ?? defaultMapping, layer.Transform);
        int edge = layer.IsDecal ? AddCoordinates(place) : -1;
        if (texture.Needs == TextureNeeds.None)
        {
            float alpha = texture.HasAlpha ? texture.Alpha(default) : 1;
            return new CompiledLayer(-1, -1, edge, texture.Sample(default) * alpha, alpha, layer.Blend, layer.Opacity);
        }

        int color = Add(texture, place, texture.HasAlpha ? TextureUse.Premultiplied : TextureUse.Color);
        int alphaLookup = texture.HasAlpha ? Add(texture, place, TextureUse.Alpha) : -1;
        return new CompiledLayer(color, alphaLookup, edge, Intensity.Black, 1, layer.Blend, layer.Opacity);
    }

    /// <summary>Reduces a number slot.</summary>
    public CompiledScalar Compile(ScalarSlot slot)
    {
        if (slot.Texture is not { } texture || slot.Amount == 0)
        {
            return new CompiledScalar(slot, slot.Value, -1);
        }

        bool readsAlpha = slot.Channel == TextureChannel.Alpha;
        if (readsAlpha && !texture.HasAlpha)
        {
            return new CompiledScalar(slot, slot.Apply(Intensity.White), -1);
        }

        return texture.Needs == TextureNeeds.None
            ? new CompiledScalar(slot, slot.Apply(readsAlpha ? Intensity.Grey(texture.Alpha(default)) : texture.Sample(default)), -1)
            : new CompiledScalar(slot, slot.Value, Add(texture, slot.Mapping, slot.Transform, readsAlpha ? TextureUse.Alpha : TextureUse.Data));
    }

    /// <summary>Adds a lookup, or finds it.</summary>
    /// <returns>Its number.</returns>
    public int Add(ITexture texture, IMapping? mapping, UvTransform transform, TextureUse use) =>
        Add(texture, new CompiledCoordinates(mapping ?? defaultMapping, transform), use);

    private int Add(ITexture texture, in CompiledCoordinates coordinates, TextureUse use)
    {
        (ITexture, TextureUse, int) key = (texture, use, (texture.Needs & TextureNeeds.Coordinate) == 0 ? -1 : AddCoordinates(coordinates));
        int known = _keys.IndexOf(key);
        return known >= 0 ? known : Append(key, new CompiledLookup(textures.Prepare(texture, use), textures.Needs(texture), key.Item3));
    }

    /// <summary>Adds the slopes of heights.</summary>
    /// <param name="bump">Heights; with a texture.</param>
    /// <returns>Number of the lookup.</returns>
    public int AddSlopes(ScalarSlot bump)
    {
        ITexture texture = bump.Texture!;
        IMapping mapping = bump.Mapping ?? defaultMapping;
        int coordinates = (texture.Needs & TextureNeeds.Coordinate) == 0 ? -1 : AddCoordinates(mapping, bump.Transform);
        return Append(default, new CompiledLookup(textures.PrepareSlopes(texture, bump.Channel, mapping), textures.Needs(texture), coordinates));
    }

    /// <summary>Adds the colour of a texture with alpha, weighted by alpha: filtered colour times alpha over filtered alpha.</summary>
    private int AddWeighted(ITexture texture, IMapping? mapping, UvTransform transform)
    {
        int alpha = Add(texture, mapping, transform, TextureUse.Alpha);
        (ITexture, TextureUse, int) key = (texture, TextureUse.Color, _lookups[alpha].Coordinates);
        int known = _keys.IndexOf(key);
        return known >= 0
            ? known
            : Append(key, new CompiledLookup(textures.Prepare(texture, TextureUse.Premultiplied), textures.Needs(texture), key.Item3) { Alpha = alpha });
    }

    private int Append((ITexture Texture, TextureUse Use, int Coordinates) key, CompiledLookup lookup)
    {
        _keys.Add(key);
        _lookups.Add(lookup);
        return _lookups.Count - 1;
    }

    /// <summary>Adds a coordinate set, or finds it.</summary>
    /// <returns>Its number.</returns>
    public int AddCoordinates(IMapping? mapping, UvTransform transform) => AddCoordinates(new CompiledCoordinates(mapping ?? defaultMapping, transform));

    private int AddCoordinates(in CompiledCoordinates set)
    {
        int index = _coordinates.IndexOf(set);
        if (index < 0)
        {
            _coordinates.Add(set);
            index = _coordinates.Count - 1;
        }

        return index;
    }
}
