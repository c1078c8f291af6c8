namespace LabRaytracer;

/// <summary>Columns of gradients of u and v with respect to the local point.</summary>
/// <typeparam name="T">Lane type.</typeparam>
internal unsafe struct GradientBatch<T>
    where T : unmanaged, IReal<T>
{
    /// <summary>Gradient of u, object space.</summary>
    public T* UX, UY, UZ;

    /// <summary>Gradient of v, object space.</summary>
    public T* VX, VY, VZ;

    /// <summary>Columns of the gradient of u.</summary>
    public readonly VectorColumns<T> U => new(UX, UY, UZ);

    /// <summary>Columns of the gradient of v.</summary>
    public readonly VectorColumns<T> V => new(VX, VY, VZ);

    /// <summary>New columns.</summary>
    /// <param name="memory">Owns them.</param>
    /// <param name="capacity">Scalars in each.</param>
    public GradientBatch(LaneMemory memory, int capacity)
    {
        UX = memory.Column<T>(capacity, T.Width);
        UY = memory.Column<T>(capacity, T.Width);
        UZ = memory.Column<T>(capacity, T.Width);
        VX = memory.Column<T>(capacity, T.Width);
        VY = memory.Column<T>(capacity, T.Width);
        VZ = memory.Column<T>(capacity, T.Width);
    }

    /// <summary>Writes one group of lanes.</summary>
    public readonly void Store(int packet, in GradientLanes<T> gradient)
    {
        UX[packet] = gradient.UX;
        UY[packet] = gradient.UY;
        UZ[packet] = gradient.UZ;
        VX[packet] = gradient.VX;
        VY[packet] = gradient.VY;
        VZ[packet] = gradient.VZ;
    }

    /// <summary>Writes one gradient.</summary>
    public readonly void Put(int element, in MappingGradient gradient)
    {
        Lane.Put(UX, element, gradient.U.X);
        Lane.Put(UY, element, gradient.U.Y);
        Lane.Put(UZ, element, gradient.U.Z);
        Lane.Put(VX, element, gradient.V.X);
        Lane.Put(VY, element, gradient.V.Y);
        Lane.Put(VZ, element, gradient.V.Z);
    }

    /// <summary>Reads one gradient.</summary>
    public readonly MappingGradient Take(int element) => new(
        new Vector3D(Lane.Take(UX, element), Lane.Take(UY, element), Lane.Take(UZ, element)),
        new Vector3D(Lane.Take(VX, element), Lane.Take(VY, element), Lane.Take(VZ, element)));
}
