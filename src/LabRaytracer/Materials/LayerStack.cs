namespace LabRaytracer;

/// <summary>A coefficient with the layers over it.</summary>
/// <param name="Base">The coefficient.</param>
/// <param name="Layers">The layers from the bottom up.</param>
internal sealed record LayerStack(CompiledSlot Base, CompiledLayer[] Layers);
