namespace LabRaytracer;

/// <summary>What a render gives back.</summary>
/// <param name="Picture">The picture, linear, row 0 on top.</param>
/// <param name="Statistics">What was done.</param>
public sealed record RenderResult(Picture Picture, RenderStatistics Statistics);
