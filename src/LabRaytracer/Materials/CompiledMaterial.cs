namespace LabRaytracer;

/// <summary>A material on a kind of shape, reduced to what has to be computed for each hit.</summary>
internal sealed class CompiledMaterial
{
    private readonly List<(ITexture Texture, bool IsData, int Coordinates)> _lookupKeys = [];
    private readonly List<CompiledLookup> _lookups = [];
    private readonly List<CompiledCoordinates> _coordinates = [];

    /// <summary>Reduces a material.</summary>
    /// <param name="material">The material.</param>
    /// <param name="defaultMapping">Mapping of slots that do not name one.</param>
    /// <param name="textures">Makes textures ready.</param>
    public CompiledMaterial(Material material, IMapping defaultMapping, TexturePreparation textures)
    {
        Material = material;
        DefaultMapping = defaultMapping;
        CompiledSlot Slot(TextureSlot slot) => Compile(slot, defaultMapping, textures);
        Diffuse = Slot(material.Diffuse);
        Ambient = material.Ambient is null ? Diffuse : Slot(material.Ambient);
        Specular = material.Shader.UsesSpecular ? Slot(material.Specular) : new CompiledSlot(Intensity.Black, -1, default, 1);
        Shininess = Specular.IsBlack ? new CompiledScalar(material.Shininess, material.Shininess.Value, -1) : Compile(material.Shininess, defaultMapping, textures);
        Reflection = Slot(material.Reflection);
        Transparency = Slot(material.Transparency);
        IndexOfRefraction = Transparency.IsBlack
            ? new CompiledScalar(material.IndexOfRefraction, material.IndexOfRefraction.Value, -1)
            : Compile(material.IndexOfRefraction, defaultMapping, textures);
        Emission = Slot(material.Emission);
        Needs = FindNeeds();
        ConstantSlots = new[]
        {
            Diffuse.Lookup, Ambient.Lookup, Specular.Lookup, Shininess.Lookup, Reflection.Lookup, Transparency.Lookup, IndexOfRefraction.Lookup, Emission.Lookup,
        }.Count(lookup => lookup < 0);
    }

    /// <summary>The material.</summary>
    public Material Material { get; }

    /// <summary>Mapping of slots that do not name one.</summary>
    public IMapping DefaultMapping { get; }

    /// <summary>k_a.</summary>
    public CompiledSlot Ambient { get; }

    /// <summary>k_d.</summary>
    public CompiledSlot Diffuse { get; }

    /// <summary>k_s.</summary>
    public CompiledSlot Specular { get; }

    /// <summary>k_r.</summary>
    public CompiledSlot Reflection { get; }

    /// <summary>k_t.</summary>
    public CompiledSlot Transparency { get; }

    /// <summary>Light of its own.</summary>
    public CompiledSlot Emission { get; }

    /// <summary>Specular exponent.</summary>
    public CompiledScalar Shininess { get; }

    /// <summary>Index of refraction.</summary>
    public CompiledScalar IndexOfRefraction { get; }

    /// <summary>Distinct textures.</summary>
    public IReadOnlyList<CompiledLookup> Lookups => _lookups;

    /// <summary>Distinct mappings.</summary>
    public IReadOnlyList<CompiledCoordinates> Coordinates => _coordinates;

    /// <summary>Columns of surface points that mappings and 3D textures read.</summary>
    public SurfaceNeeds Needs { get; }

    /// <summary>Number of slots that are the same everywhere.</summary>
    public int ConstantSlots { get; }

    /// <summary>Tells whether lamps matter.</summary>
    public bool IsLit => !Diffuse.IsBlack || !Specular.IsBlack || Material.Shader is not IWideShader;

    /// <summary>Tells whether the material mirrors or transmits.</summary>
    public bool HasSecondaryRays => !Reflection.IsBlack || !Transparency.IsBlack;

    private CompiledSlot Compile(TextureSlot slot, IMapping defaultMapping, TexturePreparation textures)
    {
        if (slot.Texture is null || !slot.IsTextured)
        {
            return new CompiledSlot(slot.Value, -1, slot.Blend, 1);
        }

        return slot.Texture.Needs == TextureNeeds.None
            ? new CompiledSlot(slot.Apply(slot.Texture.Sample(default)), -1, slot.Blend, 1)
            : new CompiledSlot(slot.Value, Lookup(slot.Texture, slot.Mapping ?? defaultMapping, slot.Transform, isData: false, textures), slot.Blend, slot.Amount);
    }

    private CompiledScalar Compile(ScalarSlot slot, IMapping defaultMapping, TexturePreparation textures)
    {
        if (slot.Texture is null || slot.Amount == 0)
        {
            return new CompiledScalar(slot, slot.Value, -1);
        }

        return slot.Texture.Needs == TextureNeeds.None
            ? new CompiledScalar(slot, slot.Apply(slot.Texture.Sample(default)), -1)
            : new CompiledScalar(slot, slot.Value, Lookup(slot.Texture, slot.Mapping ?? defaultMapping, slot.Transform, isData: true, textures));
    }

    private int Lookup(ITexture texture, IMapping mapping, UvTransform transform, bool isData, TexturePreparation textures)
    {
        int coordinates = (texture.Needs & TextureNeeds.Coordinate) == 0 ? -1 : IndexOf(_coordinates, new CompiledCoordinates(mapping, transform));
        (ITexture, bool, int) key = (texture, isData, coordinates);
        int known = _lookupKeys.IndexOf(key);
        if (known >= 0)
        {
            return known;
        }

        _lookupKeys.Add(key);
        _lookups.Add(new CompiledLookup(textures.Prepare(texture, isData), texture.Needs, coordinates));
        return _lookups.Count - 1;
    }

    private static int IndexOf(List<CompiledCoordinates> list, CompiledCoordinates item)
    {
        int index = list.IndexOf(item);
        if (index < 0)
        {
            list.Add(item);
            index = list.Count - 1;
        }

        return index;
    }

    private SurfaceNeeds FindNeeds()
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
