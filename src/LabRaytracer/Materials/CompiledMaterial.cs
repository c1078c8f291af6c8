namespace LabRaytracer;

/// <summary>A material on a kind of shape, reduced to what has to be computed for each hit.</summary>
internal sealed class CompiledMaterial
{
    /// <summary>Reduces a material.</summary>
    /// <param name="material">The material.</param>
    /// <param name="defaultMapping">Mapping of slots that do not name one.</param>
    /// <param name="textures">Makes textures ready.</param>
    /// <param name="filler">White texture that colours without texture are multiplied by, so that nothing is left out; null (default): they are constants.</param>
    public CompiledMaterial(Material material, IMapping defaultMapping, TexturePreparation textures, ITexture? filler = null)
    {
        Material = material;
        DefaultMapping = defaultMapping;
        Textures = new LookupList(defaultMapping, textures);
        Inside = material.Inside is { } inside ? new CompiledMaterial(inside, defaultMapping, textures, filler) : null;
        Opacity = CompiledOpacity.Of(material, defaultMapping, textures);
        ITexture? cutOut = Opacity is not null && material.Opacity.Channel == TextureChannel.Alpha ? material.Opacity.Texture : null;
        CompiledSlot Slot(TextureSlot slot) => Filled(Textures.Compile(slot, cutOut), filler);
        CompiledScalar Number(ScalarSlot slot, bool isUsed) => isUsed ? Textures.Compile(slot) : new CompiledScalar(slot, slot.Value, -1);
        Diffuse = Slot(material.Diffuse);
        Ambient = material.Ambient is null ? Diffuse : Slot(material.Ambient);
        Specular = material.Shader.UsesSpecular ? Slot(material.Specular) : new CompiledSlot(Intensity.Black, -1, default, 1);
        Shininess = Number(material.Shininess, !Specular.IsBlack);
        Reflection = Slot(material.Reflection);
        Transparency = Slot(material.Transparency);
        IndexOfRefraction = Number(material.IndexOfRefraction, !Transparency.IsBlack);
        Emission = Slot(material.Emission);
        Occlusion = Number(material.Occlusion, !Ambient.IsBlack);
        LightMap = Diffuse.IsBlack ? new CompiledSlot(Intensity.Black, -1, default, 1) : Slot(material.LightMap);
        Relief = CompiledRelief.Of(material, Textures);
        ConstantSlots = new[]
        {
            Diffuse.Lookup, Ambient.Lookup, Specular.Lookup, Shininess.Lookup, Reflection.Lookup, Transparency.Lookup, IndexOfRefraction.Lookup, Emission.Lookup,
        }.Count(lookup => lookup < 0);
    }

    /// <summary>A constant that is not black as the product of itself and white, looked up.</summary>
    private CompiledSlot Filled(CompiledSlot slot, ITexture? filler) => filler is null || slot.Lookup >= 0 || slot.IsBlack
        ? slot
        : new CompiledSlot(slot.Value, Textures.Add(filler, null, UvTransform.Identity, TextureUse.Color), BlendMode.Multiply, 1);

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

    /// <summary>Factor of ambient light.</summary>
    public CompiledScalar Occlusion { get; }

    /// <summary>Light that was computed beforehand.</summary>
    public CompiledSlot LightMap { get; }

    /// <summary>How much of the surface is there; null where all of it.</summary>
    public CompiledOpacity? Opacity { get; }

    /// <summary>What tilts the normals; null if nothing does.</summary>
    public CompiledRelief? Relief { get; }

    /// <summary>Textures and mappings of all slots but the opacity.</summary>
    public LookupList Textures { get; }

    /// <summary>The material of the side that normals point away from; null where it is the same.</summary>
    public CompiledMaterial? Inside { get; }

    /// <summary>Distinct textures.</summary>
    public IReadOnlyList<CompiledLookup> Lookups => Textures.Lookups;

    /// <summary>Distinct mappings.</summary>
    public IReadOnlyList<CompiledCoordinates> Coordinates => Textures.Coordinates;

    /// <summary>Columns of surface points that mappings and 3D textures read.</summary>
    public SurfaceNeeds Needs => Textures.Needs;

    /// <summary>Textures and mappings by what is computed at once.</summary>
    public IEnumerable<LookupList> AllTextures =>
        new[] { Textures, Opacity?.Lookups }.OfType<LookupList>().Concat(Inside?.AllTextures ?? []);

    /// <summary>What must be known of steps on the surface if rays carry differentials; how normals bend is told by the local point.</summary>
    public StepNeeds Steps => Textures.Steps | (HasSecondaryRays ? StepNeeds.Normal : StepNeeds.None);

    /// <summary>Number of slots that are the same everywhere.</summary>
    public int ConstantSlots { get; }

    /// <summary>Tells whether lamps matter.</summary>
    public bool IsLit => (!Diffuse.IsBlack || !Specular.IsBlack || Material.Shader is not IWideShader)
        && (LightMap.IsBlack || Material.LightMapMode == LightMapMode.Add);

    /// <summary>Tells whether ambient light is weakened.</summary>
    public bool IsOccluded => Occlusion.Lookup >= 0 || Occlusion.Value != 1;

    /// <summary>Tells whether the material mirrors or transmits.</summary>
    public bool HasSecondaryRays => !Reflection.IsBlack || !Transparency.IsBlack;
}
