namespace LabRaytracer;

/// <summary>What a flat shape tells its kernel.</summary>
internal interface IFlatShape
{
    /// <summary>The shape's local frame.</summary>
    FlatFrame Frame { get; }
}
