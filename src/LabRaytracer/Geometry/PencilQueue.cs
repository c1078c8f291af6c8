using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Leaves that parts of a pencil meet, which wait until there are enough of them to be prepared together, and what was found for them.</summary>
internal unsafe struct PencilQueue
{
    /// <summary>Most leaves.</summary>
    public const int Most = 4;

    private const int PartBits = 8, MostPairs = Most * BvhWide.MostItems * MeshPencil.MostPackets;

    /// <summary>Leaves that wait.</summary>
    public int Leaves;

    /// <summary>For each leaf from the lowest bits on, bits of the parts that meet it, as many as there may be parts.</summary>
    public ulong Parts;

    /// <summary>The leaves' first triangles; one more has room that does not count yet.</summary>
    public fixed int First[Most + 1];

    /// <summary>How many triangles they have.</summary>
    public fixed int Count[Most + 1];

    /// <summary>Groups of pairs, each of which has one that may hit.</summary>
    public int Groups;

    /// <summary>Pairs that may hit, in all groups.</summary>
    public int Pairs;

    /// <summary>Bits of the pairs of a group: triangle k mod 4 of the leaf with part k / 4 after the first; behind the last group 0.</summary>
    public fixed uint Bits[(Most * MeshPencil.MostPackets) + 1];

    /// <summary>Leaf and first part of a group (<see cref="Of"/>).</summary>
    public fixed int From[(Most * MeshPencil.MostPackets) + 1];

    /// <summary>Pairs of which some ray may hit the triangle within its limit.</summary>
    public int Hits;

    /// <summary>Place among the prepared triangles, and part, of each of them (<see cref="Of"/>).</summary>
    public fixed int Hit[MostPairs + 1];

    /// <summary>Adds a leaf, if there is a part that meets it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(int first, int count, uint parts)
    {
        First[Leaves] = first;
        Count[Leaves] = count;
        Parts |= (ulong)parts << (Leaves * MeshPencil.MostPackets);
        Leaves += parts != 0 ? 1 : 0;
    }

    /// <summary>Leaves that waited do so no longer.</summary>
    public void Clear()
    {
        Leaves = 0;
        Parts = 0;
    }

    /// <summary>A place and a part in one number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Of(int place, int part) => (place << PartBits) | part;

    /// <summary>The place of such a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int PlaceOf(int number) => number >> PartBits;

    /// <summary>The part of such a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int PartOf(int number) => number & ((1 << PartBits) - 1);
}
