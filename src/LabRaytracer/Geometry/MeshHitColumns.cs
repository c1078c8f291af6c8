using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Hits on a mesh, four at a time.</summary>
/// <typeparam name="Q">Four lanes of geometry's precision.</typeparam>
/// <param name="a">Weights of vertex 1, ray by ray.</param>
/// <param name="b">Weights of vertex 2, ray by ray.</param>
/// <param name="part">Triangle numbers, ray by ray.</param>
/// <param name="order">Numbers of the rays in increasing order, padded to whole groups of lanes.</param>
/// <param name="count">How many are not padding.</param>
/// <param name="quads">How many fours of them, padding included.</param>
internal readonly unsafe struct MeshHitColumns<Q>(Q* a, Q* b, int* part, int* order, int count, int quads)
    where Q : unmanaged, ILane<Q, Float4, Int4>, IQuad<Q>
{
    private readonly Q* _a = a, _b = b;
    private readonly int* _part = part, _order = order;
    private readonly int _count = count;

    /// <summary>How many fours of hits.</summary>
    public readonly int Quads = quads;

    /// <summary>The rays of four hits.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public LaneRun<Int4> Run(int quad) => new(_order, quad * Int4.Width, _count);

    /// <summary>Where in their triangles they are.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Weights(int quad, out Q a, out Q b)
    {
        LaneRun<Int4> run = Run(quad);
        (a, b) = (run.Collect<Q, Float4>(_a), run.Collect<Q, Float4>(_b));
    }

    /// <summary>Three numbers of vertex 0 of their triangles, and by how much vertices 1 and 2 differ from them.</summary>
    /// <param name="rows">The numbers.</param>
    /// <param name="corners">Vertices of triangles.</param>
    /// <param name="stride">Numbers of a vertex.</param>
    /// <param name="quad">Which four hits.</param>
    /// <param name="x0">First number of vertex 0.</param>
    /// <param name="y0">Second number.</param>
    /// <param name="z0">Third number.</param>
    /// <param name="x1">Difference of vertex 1.</param>
    /// <param name="y1">Difference of the second numbers.</param>
    /// <param name="z1">Difference of the third numbers.</param>
    /// <param name="x2">Difference of vertex 2.</param>
    /// <param name="y2">Difference of the second numbers.</param>
    /// <param name="z2">Difference of the third numbers.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Edges<P>(
        P rows, int* corners, int stride, int quad, out Q x0, out Q y0, out Q z0, out Q x1, out Q y1, out Q z1, out Q x2, out Q y2, out Q z2)
        where P : struct, IMeshPositions
    {
        int* ray = _order + (quad * Int4.Width);
        int* first = corners + (3 * _part[ray[0]]), second = corners + (3 * _part[ray[1]]), third = corners + (3 * _part[ray[2]]), fourth = corners + (3 * _part[ray[3]]);
        Vertices(rows, stride * first[0], stride * second[0], stride * third[0], stride * fourth[0], out x0, out y0, out z0);
        Vertices(rows, stride * first[1], stride * second[1], stride * third[1], stride * fourth[1], out x1, out y1, out z1);
        Vertices(rows, stride * first[2], stride * second[2], stride * third[2], stride * fourth[2], out x2, out y2, out z2);
        (x1, y1, z1) = (x1 - x0, y1 - y0, z1 - z0);
        (x2, y2, z2) = (x2 - x0, y2 - y0, z2 - z0);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Vertices<P>(P rows, int a, int b, int c, int d, out Q x, out Q y, out Q z)
        where P : struct, IMeshPositions => Q.Turn(rows.Row<Q>(a), rows.Row<Q>(b), rows.Row<Q>(c), rows.Row<Q>(d), out x, out y, out z);
}
