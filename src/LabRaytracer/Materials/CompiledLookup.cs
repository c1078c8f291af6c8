namespace LabRaytracer;

/// <summary>One texture of a material, looked up once however many slots use it.</summary>
/// <param name="Sampler">The texture made ready; null for what is composed of earlier lookups.</param>
/// <param name="Needs">What it needs of a hit.</param>
/// <param name="Coordinates">Number of the coordinate set it reads, or -1.</param>
internal sealed record CompiledLookup(TextureSampler? Sampler, TextureNeeds Needs, int Coordinates)
{
    /// <summary>Number of the earlier lookup whose alpha the colours are divided by, or -1.</summary>
    public int Alpha { get; init; } = -1;

    /// <summary>What the colours are composed of where there is no sampler.</summary>
    public LayerStack? Stack { get; init; }
}
