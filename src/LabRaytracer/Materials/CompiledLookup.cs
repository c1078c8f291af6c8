namespace LabRaytracer;

/// <summary>One texture of a material, looked up once however many slots use it.</summary>
/// <param name="Sampler">The texture made ready.</param>
/// <param name="Needs">What it needs of a hit.</param>
/// <param name="Coordinates">Number of the coordinate set it reads, or -1.</param>
internal readonly record struct CompiledLookup(TextureSampler Sampler, TextureNeeds Needs, int Coordinates);
