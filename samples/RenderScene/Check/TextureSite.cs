using LabRaytracer;

namespace RenderScene;

/// <summary>One place where a scene uses a texture.</summary>
/// <param name="Owner">The material's name, or what else it is.</param>
/// <param name="Slot">The coefficient, by its key in scene files.</param>
/// <param name="Texture">The texture.</param>
/// <param name="Mapping">The mapping that applies there.</param>
/// <param name="Transform">Transform of (u, v).</param>
internal sealed record TextureSite(string Owner, string Slot, ITexture Texture, IMapping Mapping, UvTransform Transform)
{
    /// <summary>Tells whether the slot reads numbers instead of colours.</summary>
    public bool IsData { get; init; }

    /// <summary>The channel that is read; null for colours and normals.</summary>
    public TextureChannel? Channel { get; init; }

    /// <summary>Tells whether the texture is there once, cut off outside of its place.</summary>
    public bool IsDecal { get; init; }

    /// <summary>The normal map that it is, or null.</summary>
    public NormalMap? NormalMap { get; init; }

    /// <summary>All places of a scene, each once.</summary>
    public static IEnumerable<TextureSite> Of(Scene scene)
    {
        IEnumerable<TextureSite> all = scene.Objects.SelectMany(item => Of(item.Material, item.Shape.DefaultMapping));
        return all.Concat(Color("the scene", "background", scene.Background, new SphericalMapping())).Distinct();
    }

    private static IEnumerable<TextureSite> Of(Material material, IMapping mapping)
    {
        string owner = material.Name.Length == 0 ? "a material without a name" : $"material '{material.Name}'";
        return new[]
        {
            Color(owner, "ambient", material.Ambient, mapping), Color(owner, "diffuse", material.Diffuse, mapping),
            Color(owner, "specular", material.Specular, mapping), Color(owner, "reflection", material.Reflection, mapping),
            Color(owner, "transparency", material.Transparency, mapping), Color(owner, "emission", material.Emission, mapping),
            Color(owner, "lightMap", material.LightMap, mapping), Number(owner, "shininess", material.Shininess, mapping),
            Number(owner, "indexOfRefraction", material.IndexOfRefraction, mapping), Number(owner, "opacity", material.Opacity, mapping),
            Number(owner, "occlusion", material.Occlusion, mapping), Number(owner, "bump", material.Bump, mapping),
            Normals(owner, material.NormalMap, mapping), material.Inside is null ? [] : Of(material.Inside, mapping),
        }.SelectMany(sites => sites);
    }

    private static IEnumerable<TextureSite> Color(string owner, string name, TextureSlot? slot, IMapping mapping)
    {
        if (slot?.Texture is { } texture)
        {
            yield return new TextureSite(owner, name, texture, slot.Mapping ?? mapping, slot.Transform);
        }

        foreach (TextureLayer layer in slot?.Layers ?? [])
        {
            yield return new TextureSite(owner, name, layer.Texture, layer.Mapping ?? mapping, layer.Transform) { IsDecal = layer.IsDecal };
        }
    }

    private static IEnumerable<TextureSite> Number(string owner, string name, ScalarSlot? slot, IMapping mapping)
    {
        if (slot?.Texture is { } texture)
        {
            yield return new TextureSite(owner, name, texture, slot.Mapping ?? mapping, slot.Transform) { IsData = true, Channel = slot.Channel };
        }
    }

    private static IEnumerable<TextureSite> Normals(string owner, NormalMap? map, IMapping mapping)
    {
        if (map is not null)
        {
            yield return new TextureSite(owner, "normalMap", map.Texture, map.Mapping ?? mapping, map.Transform) { IsData = true, NormalMap = map };
        }
    }
}
