namespace LabRaytracer;

/// <summary>What happens to the hits of rays that are known by their numbers.</summary>
/// <typeparam name="R1">One lane of geometry's precision.</typeparam>
internal interface IMeshCrowdSink<R1>
    where R1 : unmanaged, ILane<R1, Float1, Int1>
{
    /// <summary>Takes a hit.</summary>
    /// <param name="ray">Number of the ray: its place, counted over all crowds.</param>
    /// <param name="t">Its ray parameter, 0 &lt; t &lt;= limit.</param>
    /// <param name="weight1">Weight of vertex 1.</param>
    /// <param name="weight2">Weight of vertex 2.</param>
    /// <param name="triangle">Number of the triangle.</param>
    /// <param name="limit">Ray parameter beyond which hits do not matter; below 0 to end the ray.</param>
    /// <returns>Whether the limit was lowered.</returns>
    bool Take(int ray, R1 t, R1 weight1, R1 weight2, int triangle, ref R1 limit);
}
