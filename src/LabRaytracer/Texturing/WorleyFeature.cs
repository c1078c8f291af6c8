namespace LabRaytracer;

/// <summary>What a cell texture makes of the distances to the nearest feature points.</summary>
public enum WorleyFeature
{
    /// <summary>Distance to the nearest point.</summary>
    F1,

    /// <summary>Distance to the second nearest point.</summary>
    F2,

    /// <summary>Their difference: 0 on the borders between the regions of the points.</summary>
    F2MinusF1,
}
