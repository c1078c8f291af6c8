using System.Diagnostics.CodeAnalysis;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Keeps the nearest hit; on a tie the smaller object number, then the smaller triangle number, as <see cref="HitBatch{R, F, I}"/> promises.</summary>
internal readonly unsafe struct MeshNearestSink<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Makes an empty one, to be filled.</summary>
    public MeshNearestSink()
    {
    }

    /// <param name="hits">Where hits are kept.</param>
    /// <param name="packet">Which group of lanes.</param>
    /// <param name="number">Number of the mesh's object.</param>
    [SetsRequiredMembers]
    public MeshNearestSink(HitBatch<R, F, I> hits, int packet, int number)
    {
        Object = number;
        T = hits.T + packet;
        A = hits.A + packet;
        B = hits.B + packet;
        Objects = hits.Object + packet;
        Parts = hits.Part + packet;
    }

    /// <summary>Number of the mesh's object.</summary>
    public required int Object { get; init; }

    /// <summary>Known distances.</summary>
    public required R* T { get; init; }

    /// <summary>Known weights of vertex 1.</summary>
    public required R* A { get; init; }

    /// <summary>Known weights of vertex 2.</summary>
    public required R* B { get; init; }

    /// <summary>Known object numbers.</summary>
    public required I* Objects { get; init; }

    /// <summary>Known triangle numbers.</summary>
    public required I* Parts { get; init; }

    /// <summary>Takes the hits of one triangle.</summary>
    /// <param name="mask">Lanes that hit at <paramref name="t"/>, with 0 &lt; t &lt;= limit; at least one.</param>
    /// <param name="t">Ray parameters.</param>
    /// <param name="weight1">Weights of vertex 1.</param>
    /// <param name="weight2">Weights of vertex 2.</param>
    /// <param name="triangle">Number of the triangle.</param>
    /// <param name="limit">Ray parameters beyond which hits do not matter.</param>
    /// <returns>Whether a limit was lowered.</returns>
    public bool Take(in R mask, in R t, in R weight1, in R weight2, int triangle, ref R limit) => Take(mask, t, weight1, weight2, I.Of(triangle), ref limit);

    /// <summary>Takes hits, each of a triangle of its own.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public bool Take(in R mask, in R t, in R weight1, in R weight2, in I part, ref R limit)
    {
        I self = I.Of(Object);
        R closer = mask & R.Less(t, limit);
        R tie = mask & R.Equal(t, limit);
        if (R.Any(tie))
        {
            I isKnown = ~I.Equal(*Objects, I.Of(HitBatch<R, F, I>.Miss));
            I wins = I.Less(self, *Objects) | (I.Equal(self, *Objects) & I.Less(part, *Parts));
            closer |= tie & R.MaskFromInt32(wins & isKnown);
        }

        if (!R.Any(closer))
        {
            return false;
        }

        I closerIndex = R.MaskToInt32(closer);
        limit = R.Select(closer, t, limit);
        *T = R.Select(closer, t, *T);
        *A = R.Select(closer, weight1, *A);
        *B = R.Select(closer, weight2, *B);
        *Objects = I.Select(closerIndex, self, *Objects);
        *Parts = I.Select(closerIndex, part, *Parts);
        return true;
    }
}
