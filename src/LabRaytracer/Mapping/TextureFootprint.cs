namespace LabRaytracer;

/// <summary>What a sample covers of texture space: the change of (u, v) from one sample to the next one beside it and below it.</summary>
/// <param name="DuDx">Change of u over one sample to the right, texture units.</param>
/// <param name="DvDx">Change of v over one sample to the right, texture units.</param>
/// <param name="DuDy">Change of u over one sample down, texture units.</param>
/// <param name="DvDy">Change of v over one sample down, texture units.</param>
/// <remarks>
/// The footprint is the parallelogram spanned by (DuDx, DvDx) and (DuDy, DvDy), its centre at the lookup's coordinates. All zero (the default value): a point.
/// With n samples a pixel the steps are those of a pixel divided by sqrt(n). Immutable, thread safe.
/// </remarks>
public readonly record struct TextureFootprint(double DuDx, double DvDx, double DuDy, double DvDy)
{
    /// <summary>Tells whether the footprint is a point: nothing is filtered.</summary>
    public bool IsPoint => this == default;

    /// <summary>Extent along u of the parallelogram: |DuDx| + |DuDy|, texture units.</summary>
    public double ExtentU => Math.Abs(DuDx) + Math.Abs(DuDy);

    /// <summary>Extent along v of the parallelogram: |DvDx| + |DvDy|, texture units.</summary>
    public double ExtentV => Math.Abs(DvDx) + Math.Abs(DvDy);
}
