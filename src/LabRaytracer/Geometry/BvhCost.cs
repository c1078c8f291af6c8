namespace LabRaytracer;

/// <summary>What a tree of boxes weighs when it decides whether to split on (surface area heuristic).</summary>
/// <param name="ItemCost">Cost of testing one item, in tests of two boxes.</param>
/// <param name="MaximumLeaf">Most items that a leaf may hold, at least 1.</param>
internal readonly record struct BvhCost(float ItemCost, int MaximumLeaf);
