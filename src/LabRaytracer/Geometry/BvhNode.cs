using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>A node of a binary tree of boxes: 32 bytes, so that two children fill one cache line.</summary>
[StructLayout(LayoutKind.Sequential)]
internal struct BvhNode
{
    /// <summary>How many floats lie between a coordinate's minimum and its maximum.</summary>
    public const int MaximumAfterMinimum = 4;

    /// <summary>Smallest coordinates of the box, rounded down, relative to the tree's centre.</summary>
    public float MinX, MinY, MinZ;

    /// <summary>The first item of a leaf, or the node number of the first of two children.</summary>
    public int First;

    /// <summary>Largest coordinates of the box, rounded up, relative to the tree's centre.</summary>
    public float MaxX, MaxY, MaxZ;

    /// <summary>Number of items of a leaf, above 0; else minus the axis (0, 1, 2) along which the children follow each other.</summary>
    public int Count;
}
