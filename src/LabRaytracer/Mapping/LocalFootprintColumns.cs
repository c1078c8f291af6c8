namespace LabRaytracer;

/// <summary>Columns of footprints on surfaces; floats, read as lanes of any width.</summary>
internal readonly unsafe struct LocalFootprintColumns
{
    /// <summary>Change of the local point over one sample to the right.</summary>
    public readonly float* XDx, YDx, ZDx;

    /// <summary>Change of the local point over one sample down.</summary>
    public readonly float* XDy, YDy, ZDy;

    /// <param name="memory">Owns the columns.</param>
    /// <param name="capacity">Floats in each.</param>
    public LocalFootprintColumns(LaneMemory memory, int capacity)
    {
        XDx = (float*)memory.Column<Float16>(capacity, Float16.Width);
        YDx = (float*)memory.Column<Float16>(capacity, Float16.Width);
        ZDx = (float*)memory.Column<Float16>(capacity, Float16.Width);
        XDy = (float*)memory.Column<Float16>(capacity, Float16.Width);
        YDy = (float*)memory.Column<Float16>(capacity, Float16.Width);
        ZDy = (float*)memory.Column<Float16>(capacity, Float16.Width);
    }

    /// <summary>Reads one footprint.</summary>
    public SurfaceFootprint Take(int element) => new(
        new Vector3D(XDx[element], YDx[element], ZDx[element]), new Vector3D(XDy[element], YDy[element], ZDy[element]));
}
