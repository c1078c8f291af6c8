namespace LabRaytracer;

/// <summary>Finds the textures that a render of a scene can look up.</summary>
internal static class SceneTextures
{
    /// <summary>Textures of the objects' materials and of the background, with whether their slot is data; some may repeat.</summary>
    public static IEnumerable<(ITexture Texture, bool IsData)> Used(Scene scene)
    {
        foreach (TextureSlot slot in scene.Objects.Select(item => item.Material).Distinct().SelectMany(ColorSlots).Append(scene.Background))
        {
            if (slot.Texture is not null && slot.IsTextured)
            {
                yield return (slot.Texture, false);
            }
        }

        foreach (Material material in scene.Objects.Select(item => item.Material).Distinct())
        {
            if (material.Shininess.Texture is not null && material.Shader.UsesSpecular && material.Specular is not { Texture: null, Value: { R: 0, G: 0, B: 0 } })
            {
                yield return (material.Shininess.Texture, true);
            }

            if (material.IndexOfRefraction.Texture is not null && material.Transparency is not { Texture: null, Value: { R: 0, G: 0, B: 0 } })
            {
                yield return (material.IndexOfRefraction.Texture, true);
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
        if (material.Shader.UsesSpecular)
        {
            yield return material.Specular;
        }
    }
}
