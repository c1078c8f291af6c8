namespace LabRaytracer;

/// <summary>Where a tree of boxes is: what rays are prepared for.</summary>
internal readonly struct BvhFrame
{
    /// <summary>Subtracted from coordinates before they meet the boxes.</summary>
    public readonly double CenterX, CenterY, CenterZ;

    /// <summary>Largest coordinate of the root's box, relative to the centre, in magnitude.</summary>
    public readonly float SizeX, SizeY, SizeZ;

    /// <summary>Sum of the magnitudes of all coordinates of box and centre.</summary>
    public readonly double Size;

    /// <param name="center">The centre.</param>
    /// <param name="root">The root's box.</param>
    public BvhFrame(Point3D center, in BvhNode root)
    {
        (CenterX, CenterY, CenterZ) = center;
        SizeX = Math.Max(Math.Abs(root.MinX), Math.Abs(root.MaxX));
        SizeY = Math.Max(Math.Abs(root.MinY), Math.Abs(root.MaxY));
        SizeZ = Math.Max(Math.Abs(root.MinZ), Math.Abs(root.MaxZ));
        Size = (double)SizeX + SizeY + SizeZ + Math.Abs(CenterX) + Math.Abs(CenterY) + Math.Abs(CenterZ);
    }

    /// <summary>The centre's coordinate along an axis (0, 1, 2).</summary>
    public double Center(int axis) => axis == 0 ? CenterX : axis == 1 ? CenterY : CenterZ;
}
