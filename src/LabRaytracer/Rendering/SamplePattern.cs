namespace LabRaytracer;

/// <summary>Where the samples of a pixel lie.</summary>
public enum SamplePattern
{
    /// <summary>Centres of an n x n grid. The default.</summary>
    Regular,

    /// <summary>One random point in each cell of an n x n grid, repeatable by the seed.</summary>
    Jittered,
}
