namespace LabRaytracer;

/// <summary>Columns of ray differentials, one step of the picture to the right and one down, world space.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
internal readonly struct DifferentialColumns<F>
    where F : unmanaged, IReal<F>
{
    /// <summary>Changes of origins and unit directions.</summary>
    public readonly VectorColumns<F> OriginDx, DirectionDx, OriginDy, DirectionDy;

    /// <param name="memory">Owns the columns.</param>
    /// <param name="capacity">Scalars in each.</param>
    public DifferentialColumns(LaneMemory memory, int capacity)
    {
        OriginDx = new VectorColumns<F>(memory, capacity);
        DirectionDx = new VectorColumns<F>(memory, capacity);
        OriginDy = new VectorColumns<F>(memory, capacity);
        DirectionDy = new VectorColumns<F>(memory, capacity);
    }

    /// <summary>Copies groups of lanes.</summary>
    public void CopyFrom(in DifferentialColumns<F> other, int packets)
    {
        OriginDx.CopyFrom(other.OriginDx, packets);
        DirectionDx.CopyFrom(other.DirectionDx, packets);
        OriginDy.CopyFrom(other.OriginDy, packets);
        DirectionDy.CopyFrom(other.DirectionDy, packets);
    }

    /// <summary>Moves the origins of a group of lanes along their rays.</summary>
    /// <param name="packet">Group of lanes.</param>
    /// <param name="way">How far.</param>
    public void Advance(int packet, F way)
    {
        OriginDx.Add(packet, way, DirectionDx);
        OriginDy.Add(packet, way, DirectionDy);
    }

    /// <summary>Writes one differential, rounded.</summary>
    /// <param name="element">Number of the ray.</param>
    /// <param name="value">The differential.</param>
    /// <param name="spacing">Factor: distance of samples, pixels.</param>
    public void Put(int element, in RayDifferential value, double spacing)
    {
        OriginDx.Put(element, value.OriginDx * spacing);
        DirectionDx.Put(element, value.DirectionDx * spacing);
        OriginDy.Put(element, value.OriginDy * spacing);
        DirectionDy.Put(element, value.DirectionDy * spacing);
    }

    /// <summary>Reads one differential.</summary>
    public RayDifferential Take(int element) =>
        new(OriginDx.Take(element), DirectionDx.Take(element), OriginDy.Take(element), DirectionDy.Take(element));
}
