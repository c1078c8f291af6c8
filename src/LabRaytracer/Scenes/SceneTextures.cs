namespace LabRaytracer;

/// <summary>Finds the textures that a render of a scene can look up.</summary>
internal static class SceneTextures
{
    /// <summary>Textures of the objects' materials and of the background, with what is read of them; some may repeat.</summary>
    public static IEnumerable<(ITexture Texture, TextureUse Use)> Used(Scene scene)
    {
        Material[] materials = [.. scene.Objects.Select(item => item.Material).Distinct().SelectMany(WithInside).Distinct()];
        return materials.SelectMany(Colors).Concat(materials.SelectMany(Numbers)).Concat(Colors(scene.Background, null))
            .Concat(scene.Lights.OfType<EnvironmentLight>().SelectMany(light => Colors(light.Radiance, null)));
    }

    /// <summary>Textures that slots of the objects' materials name, used or not; some may repeat.</summary>
    public static IEnumerable<ITexture> Named(Scene scene) => scene.Objects.Select(item => item.Material).Distinct().SelectMany(WithInside).SelectMany(Named).OfType<ITexture>();

    private static IEnumerable<ITexture?> Named(Material m) =>
    [
        m.Diffuse.Texture, m.Ambient?.Texture, m.Specular.Texture, m.Emission.Texture, m.Reflection.Texture, m.Transparency.Texture, m.LightMap.Texture,
        m.NormalMap?.Texture, m.Bump?.Texture, m.Shininess.Texture, m.IndexOfRefraction.Texture, m.Occlusion.Texture, m.Opacity.Texture,
        .. new[] { m.Diffuse, m.Ambient, m.Specular, m.Emission, m.Reflection, m.Transparency, m.LightMap }.SelectMany(slot => slot?.Layers.Select(layer => layer.Texture) ?? []),
    ];

    private static IEnumerable<Material> WithInside(Material material)
    {
        for (Material? side = material; side is not null; side = side.Inside)
        {
            yield return side;
        }
    }

    private static IEnumerable<(ITexture Texture, TextureUse Use)> Colors(Material material)
    {
        ITexture? cutOut = material.Opacity.Channel == TextureChannel.Alpha ? material.Opacity.Texture : null;
        return ColorSlots(material).SelectMany(slot => Colors(slot, cutOut));
    }

    private static IEnumerable<(ITexture Texture, TextureUse Use)> Colors(TextureSlot slot, ITexture? cutOut)
    {
        if (slot.Texture is not null && slot.IsTextured)
        {
            yield return (slot.Texture, slot.Texture == cutOut ? TextureUse.Premultiplied : TextureUse.Color);
        }

        foreach (TextureLayer layer in slot.Layers.Where(layer => layer.Opacity > 0))
        {
            yield return (layer.Texture, TextureUse.Premultiplied);
        }
    }

    private static IEnumerable<(ITexture Texture, TextureUse Use)> Numbers(Material material)
    {
        if (material.NormalMap is { } map)
        {
            yield return (map.Texture, TextureUse.Data);
        }

        foreach (ScalarSlot slot in NumberSlots(material))
        {
            if (slot.Texture is not null && slot.Amount > 0)
            {
                yield return (slot.Texture, slot.Channel == TextureChannel.Alpha ? TextureUse.Alpha : TextureUse.Data);
            }
        }
    }

    private static IEnumerable<TextureSlot> ColorSlots(Material material)
    {
        yield return material.Diffuse;
        yield return material.Ambient ?? material.Diffuse;
        yield return material.Emission;
        yield return material.Reflection;
        yield return material.Transparency;
        if (!IsBlack(material.Diffuse))
        {
            yield return material.LightMap;
        }

        if (material.Shader.UsesSpecular)
        {
            yield return material.Specular;
        }
    }

    private static IEnumerable<ScalarSlot> NumberSlots(Material material)
    {
        yield return material.Opacity;
        if (material.Bump is not null)
        {
            yield return material.Bump;
        }

        if (material.Shader.UsesSpecular && !IsBlack(material.Specular))
        {
            yield return material.Shininess;
        }

        if (!IsBlack(material.Transparency))
        {
            yield return material.IndexOfRefraction;
        }

        if (!IsBlack(material.Ambient ?? material.Diffuse))
        {
            yield return material.Occlusion;
        }
    }

    private static bool IsBlack(TextureSlot slot) => slot is { Texture: null, Layers.Count: 0, Value: { R: 0, G: 0, B: 0 } };
}
