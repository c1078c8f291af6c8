namespace LabRaytracer;

/// <summary>One mapping and uv transform of a material, evaluated once however many textures read it.</summary>
/// <param name="Mapping">The mapping.</param>
/// <param name="Transform">Transform of its coordinates.</param>
internal readonly record struct CompiledCoordinates(IMapping Mapping, UvTransform Transform);
