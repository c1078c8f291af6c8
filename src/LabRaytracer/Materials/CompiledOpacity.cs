namespace LabRaytracer;

/// <summary>The opacity of a material: looked up on its own, because most of the material is not needed where nothing is seen, and nothing else of it for shadows.</summary>
internal sealed class CompiledOpacity
{
    private CompiledOpacity(Material material, IMapping defaultMapping, TexturePreparation textures)
    {
        Lookups = new LookupList(defaultMapping, textures);
        Value = Lookups.Compile(material.Opacity);
    }

    /// <summary>Textures and mappings that it reads.</summary>
    public LookupList Lookups { get; }

    /// <summary>The opacity; what lies outside [0, 1] counts as the nearest end.</summary>
    public CompiledScalar Value { get; }

    /// <summary>Tells whether nothing is ever seen of the surface.</summary>
    public bool IsInvisible => Value.Lookup < 0 && Value.Value <= 0;

    /// <summary>The opacity of a material; null if it is opaque everywhere.</summary>
    public static CompiledOpacity? Of(Material material, IMapping defaultMapping, TexturePreparation textures)
    {
        CompiledOpacity opacity = new(material, defaultMapping, textures);
        return opacity.Value is { Lookup: < 0, Value: >= 1 } ? null : opacity;
    }
}
