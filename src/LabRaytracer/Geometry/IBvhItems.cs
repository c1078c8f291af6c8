namespace LabRaytracer;

/// <summary>The things that a tree of boxes sorts.</summary>
internal interface IBvhItems
{
    /// <summary>How many there are.</summary>
    int Count { get; }

    /// <summary>A box around all of them; finite where there are any.</summary>
    Bounds All { get; }

    /// <summary>Called once, before the first <see cref="Describe"/>.</summary>
    /// <param name="center">Subtracted from all coordinates.</param>
    void Prepare(Point3D center);

    /// <summary>Writes references to items [first, end), with their boxes in floats, rounded outward.</summary>
    /// <param name="center">Subtracted from all coordinates.</param>
    /// <param name="references">Where the reference of item 0 is or would be.</param>
    /// <param name="first">First item.</param>
    /// <param name="end">After the last item.</param>
    unsafe void Describe(Point3D center, BvhReference* references, int first, int end);

    /// <summary>Called once, after the last <see cref="Describe"/>: what only it needed can go.</summary>
    void Release();
}
