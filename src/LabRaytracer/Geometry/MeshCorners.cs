using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Where the numbers of the three corners of triangles start in a column.</summary>
/// <typeparam name="I">Integer lanes.</typeparam>
internal readonly unsafe struct MeshCorners<I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Element number of the first number of each corner.</summary>
    public readonly I First, Second, Third;

    /// <param name="corners">Vertex numbers, three a triangle.</param>
    /// <param name="corner">Number of each triangle's first corner.</param>
    /// <param name="stride">Numbers of one vertex.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MeshCorners(int* corners, I corner, int stride)
    {
        I size = I.Of(stride);
        First = I.Gather(corners, corner) * size;
        Second = I.Gather(corners + 1, corner) * size;
        Third = I.Gather(corners + 2, corner) * size;
    }
}
