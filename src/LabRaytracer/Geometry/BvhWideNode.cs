using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>An inner node with up to eight children: their boxes in columns, for one ray against all of them.</summary>
[StructLayout(LayoutKind.Sequential)]
internal unsafe struct BvhWideNode
{
    /// <summary>Most children.</summary>
    public const int Width = 8;

    /// <summary>Bits of a leaf's number of items.</summary>
    public const int CountBits = 3;

    /// <summary>Smallest x of each child, then y, z, then largest x, y, z; relative to the tree's centre, rounded outward. A missing child has an inside-out box.</summary>
    public fixed float Planes[6 * Width];

    /// <summary>The number of a node, or ~(first item &lt;&lt; <see cref="CountBits"/> | number of items) for a leaf.</summary>
    public fixed int Children[Width];
}
