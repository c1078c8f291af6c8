namespace LabRaytracer;

/// <summary>Computed and combined textures of scene files.</summary>
internal static class ProceduralFormats
{
    /// <summary>A texture by name or in place: what these textures are made of. Before the others, which read it.</summary>
    public static Format<ITexture> Texture { get; } = new DeferredFormat<ITexture>(() => TextureFormats.Any);

    /// <summary>All of them.</summary>
    public static IReadOnlyList<ObjectFormat<ITexture>> All { get; } = [.. PatternFormats.All, .. CombinationFormats.All];
}
