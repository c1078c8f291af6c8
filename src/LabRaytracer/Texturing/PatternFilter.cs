namespace LabRaytracer;

/// <summary>How a drawn pattern is looked up.</summary>
public enum PatternFilter
{
    /// <summary>The colour at the point: sharp, aliased where cells are smaller than pixels.</summary>
    Nearest,

    /// <summary>The mean colour of what the sample covers, by integrals of the pattern: no aliasing with one sample a pixel.</summary>
    Area,
}
