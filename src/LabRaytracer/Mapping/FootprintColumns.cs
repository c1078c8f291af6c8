namespace LabRaytracer;

/// <summary>Columns of footprints in texture space; floats, read as lanes of any width.</summary>
internal readonly unsafe struct FootprintColumns
{
    /// <summary>Change of u and v over one sample to the right.</summary>
    public readonly float* DuDx, DvDx;

    /// <summary>Change of u and v over one sample down.</summary>
    public readonly float* DuDy, DvDy;

    /// <summary>Columns that exist already.</summary>
    public FootprintColumns(float* duDx, float* dvDx, float* duDy, float* dvDy)
    {
        DuDx = duDx;
        DvDx = dvDx;
        DuDy = duDy;
        DvDy = dvDy;
    }

    /// <param name="memory">Owns the columns.</param>
    /// <param name="capacity">Floats in each; a whole number of the widest lanes.</param>
    public FootprintColumns(LaneMemory memory, int capacity)
    {
        DuDx = (float*)memory.Column<Float16>(capacity, Float16.Width);
        DvDx = (float*)memory.Column<Float16>(capacity, Float16.Width);
        DuDy = (float*)memory.Column<Float16>(capacity, Float16.Width);
        DvDy = (float*)memory.Column<Float16>(capacity, Float16.Width);
    }

    /// <param name="memory">Room for 4 columns, owned by somebody else.</param>
    /// <param name="capacity">Floats in each.</param>
    public FootprintColumns(float* memory, int capacity)
    {
        DuDx = memory;
        DvDx = memory + capacity;
        DuDy = memory + (2 * capacity);
        DvDy = memory + (3 * capacity);
    }

    /// <param name="whole">Columns.</param>
    /// <param name="first">The element to start at.</param>
    private FootprintColumns(in FootprintColumns whole, int first)
    {
        DuDx = whole.DuDx + first;
        DvDx = whole.DvDx + first;
        DuDy = whole.DuDy + first;
        DvDy = whole.DvDy + first;
    }

    /// <summary>The same columns from an element on; none of none.</summary>
    public FootprintColumns From(int element) => DuDx == null ? this : new FootprintColumns(this, element);

    /// <summary>Writes one footprint, rounded.</summary>
    public void Put(int element, in TextureFootprint footprint)
    {
        DuDx[element] = (float)footprint.DuDx;
        DvDx[element] = (float)footprint.DvDx;
        DuDy[element] = (float)footprint.DuDy;
        DvDy[element] = (float)footprint.DvDy;
    }

    /// <summary>Reads one footprint.</summary>
    public TextureFootprint Take(int element) => new(DuDx[element], DvDx[element], DuDy[element], DvDy[element]);
}
