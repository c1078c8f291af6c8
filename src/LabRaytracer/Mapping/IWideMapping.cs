namespace LabRaytracer;

/// <summary>A mapping that maps many points at a time, with the same bits as one at a time.</summary>
internal interface IWideMapping : IMapping
{
    /// <summary>Tells whether the mapping reads local normals.</summary>
    bool NeedsNormal => false;

    /// <summary>Maps the first <paramref name="packets"/> groups of lanes.</summary>
    /// <param name="positions">Points to map.</param>
    /// <param name="coordinates">Where (u, v) go.</param>
    /// <param name="packets">Number of groups of <c>R.Width</c> points.</param>
    void Map<R>(in PositionBatch<R> positions, in CoordinateBatch<R> coordinates, int packets)
        where R : unmanaged, IReal<R>;

    /// <summary>Gradients of the first <paramref name="packets"/> groups of lanes.</summary>
    /// <param name="positions">Points.</param>
    /// <param name="gradients">Where the gradients of u and v go.</param>
    /// <param name="packets">Number of groups of <c>T.Width</c> points.</param>
    void Gradients<T>(in PositionBatch<T> positions, in GradientBatch<T> gradients, int packets)
        where T : unmanaged, IReal<T>;
}
