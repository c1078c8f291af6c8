namespace LabRaytracer;

/// <summary>A render failed.</summary>
/// <param name="message">What failed, where, and what to do.</param>
/// <param name="inner">The cause.</param>
public sealed class RenderException(string message, Exception inner) : Exception(message, inner);
