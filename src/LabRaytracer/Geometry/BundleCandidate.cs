namespace LabRaytracer;

/// <summary>An object that a bundle of rays may meet.</summary>
/// <param name="Place">Its place among the objects.</param>
/// <param name="Start">No ray meets its box before this ray parameter.</param>
internal readonly record struct BundleCandidate(int Place, double Start);
