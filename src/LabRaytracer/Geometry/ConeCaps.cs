namespace LabRaytracer;

/// <summary>Whether a cone has a base.</summary>
public enum ConeCaps
{
    /// <summary>The side alone; one can look into it from below.</summary>
    Open,

    /// <summary>Closed by a disk.</summary>
    Closed,
}
