namespace LabRaytracer;

/// <summary>Columns of footprints on surfaces; floats, read as lanes of any width.</summary>
internal readonly unsafe struct LocalFootprintColumns
{
    /// <summary>Change of the local point over one sample to the right.</summary>
    public readonly float* XDx, YDx, ZDx;

    /// <summary>Change of the local point over one sample down.</summary>
    public readonly float* XDy, YDy, ZDy;

    private LocalFootprintColumns(float* xDx, float* yDx, float* zDx, float* xDy, float* yDy, float* zDy)
    {
        XDx = xDx;
        YDx = yDx;
        ZDx = zDx;
        XDy = xDy;
        YDy = yDy;
        ZDy = zDy;
    }

    /// <summary>The same memory as columns of vectors of float lanes.</summary>
    /// <param name="dx">Change over one sample to the right.</param>
    /// <param name="dy">Change over one sample down.</param>
    public static LocalFootprintColumns Of<F>(in VectorColumns<F> dx, in VectorColumns<F> dy)
        where F : unmanaged, IReal<F> => new((float*)dx.X, (float*)dx.Y, (float*)dx.Z, (float*)dy.X, (float*)dy.Y, (float*)dy.Z);

    /// <param name="memory">Room for 6 columns, owned by somebody else.</param>
    /// <param name="capacity">Floats in each.</param>
    public LocalFootprintColumns(float* memory, int capacity)
    {
        XDx = memory;
        YDx = memory + capacity;
        ZDx = memory + (2 * capacity);
        XDy = memory + (3 * capacity);
        YDy = memory + (4 * capacity);
        ZDy = memory + (5 * capacity);
    }

    /// <param name="whole">Columns.</param>
    /// <param name="first">The element to start at.</param>
    private LocalFootprintColumns(in LocalFootprintColumns whole, int first)
    {
        XDx = whole.XDx + first;
        YDx = whole.YDx + first;
        ZDx = whole.ZDx + first;
        XDy = whole.XDy + first;
        YDy = whole.YDy + first;
        ZDy = whole.ZDy + first;
    }

    /// <summary>The same columns from an element on; none of none.</summary>
    public LocalFootprintColumns From(int element) => XDx == null ? this : new LocalFootprintColumns(this, element);

    /// <summary>Reads one footprint.</summary>
    public SurfaceFootprint Take(int element) => new(
        new Vector3D(XDx[element], YDx[element], ZDx[element]), new Vector3D(XDy[element], YDy[element], ZDy[element]));
}
