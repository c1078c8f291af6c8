namespace LabRaytracer;

/// <summary>What a sample covers of a surface: the change of the local point from one sample to the next one beside it and below it.</summary>
/// <param name="DpDx">Change of the local point over one sample to the right, object space, in the tangent plane.</param>
/// <param name="DpDy">Change of the local point over one sample down, object space, in the tangent plane.</param>
/// <remarks>For textures that fill space. All zero (the default value): a point. Immutable, thread safe.</remarks>
public readonly record struct SurfaceFootprint(Vector3D DpDx, Vector3D DpDy)
{
    /// <summary>Tells whether the footprint is a point: nothing is filtered.</summary>
    public bool IsPoint => this == default;

    /// <summary>The longer of both steps, local units: what a texture that knows no direction filters over.</summary>
    public double Width => Math.Sqrt(Math.Max(DpDx.LengthSquared, DpDy.LengthSquared));
}
