using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Columns of nearest hits, one a ray.</summary>
/// <remarks>
/// Where two objects are hit at exactly the same distance, the one with the smaller number wins (then the smaller part):
/// so the result does not depend on the order of traversal.
/// </remarks>
internal sealed unsafe class HitBatch<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>The object number that stands for "nothing was hit".</summary>
    public const int Miss = int.MaxValue;

    /// <summary>Distance; the ray's limit where nothing was hit.</summary>
    public readonly R* T;

    /// <summary>Coordinates inside the part, for shapes that use them.</summary>
    public readonly R* A, B;

    /// <summary>Number of the object in the scene, or <see cref="Miss"/>.</summary>
    public readonly I* Object;

    /// <summary>Number of the shape's part.</summary>
    public readonly I* Part;

    /// <summary>Hits whose ray parameter has become more accurate when their surface was computed.</summary>
    public long Refined;

    public HitBatch(LaneMemory memory, int capacity)
    {
        T = memory.Column<R>(capacity, R.Width);
        A = memory.Column<R>(capacity, R.Width);
        B = memory.Column<R>(capacity, R.Width);
        Object = memory.Column<I>(capacity, I.Width);
        Part = memory.Column<I>(capacity, I.Width);
    }

    /// <summary>Forgets all hits: every distance becomes the ray's limit.</summary>
    public void Clear(RayBatch<R, F, I> rays)
    {
        Refined = 0;
        I miss = I.Of(Miss);
        for (int packet = 0; packet < rays.Packets; packet++)
        {
            T[packet] = rays.Limit[packet];
            Object[packet] = miss;
        }
    }

    /// <summary>Keeps the hits that are nearer than what is known (on a tie, the smaller object number).</summary>
    /// <param name="packet">Group of lanes.</param>
    /// <param name="mask">Lanes that were hit at <paramref name="t"/>, with 0 &lt; t.</param>
    /// <param name="t">Distances.</param>
    /// <param name="number">Number of the object.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Keep(int packet, R mask, R t, int number)
    {
        R known = T[packet];
        R tie = mask & R.Equal(t, known);
        mask &= R.Less(t, known);
        I self = I.Of(number);
        if (R.Any(tie))
        {
            mask |= tie & R.MaskFromInt32(I.Less(self, Object[packet]) & ~I.Equal(Object[packet], I.Of(Miss)));
        }

        if (R.Any(mask))
        {
            T[packet] = R.Select(mask, t, known);
            Object[packet] = I.Select(R.MaskToInt32(mask), self, Object[packet]);
        }
    }
}
