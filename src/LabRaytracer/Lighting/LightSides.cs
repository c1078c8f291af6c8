namespace LabRaytracer;

/// <summary>Which sides of a flat lamp shine.</summary>
public enum LightSides
{
    /// <summary>The side that the normal points to.</summary>
    Front,

    /// <summary>Both sides.</summary>
    Both,
}
