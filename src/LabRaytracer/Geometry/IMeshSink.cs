namespace LabRaytracer;

/// <summary>What happens to the hits of a mesh's triangles.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal interface IMeshSink<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Takes the hits of one triangle.</summary>
    /// <param name="mask">Lanes that hit at <paramref name="t"/>, with 0 &lt; t &lt;= limit; at least one.</param>
    /// <param name="t">Ray parameters.</param>
    /// <param name="weight1">Weights of vertex 1.</param>
    /// <param name="weight2">Weights of vertex 2.</param>
    /// <param name="triangle">Number of the triangle.</param>
    /// <param name="limit">Ray parameters beyond which hits do not matter.</param>
    /// <returns>Whether a limit was lowered.</returns>
    bool Take(in R mask, in R t, in R weight1, in R weight2, int triangle, ref R limit);
}
