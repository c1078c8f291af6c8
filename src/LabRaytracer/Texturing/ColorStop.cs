namespace LabRaytracer;

/// <summary>A colour at a place of a <see cref="ColorRamp"/>.</summary>
/// <param name="Position">The place; finite.</param>
/// <param name="Color">The colour there, linear.</param>
/// <remarks>Immutable, thread safe.</remarks>
public readonly record struct ColorStop(double Position, Intensity Color);
