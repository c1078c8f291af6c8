namespace LabRaytracer;

/// <summary>Where the samples of a pixel lie.</summary>
public enum SamplePattern
{
    /// <summary>Centres of an n x n grid. The default.</summary>
    Regular,

    /// <summary>One random point in each cell of an n x n grid, repeatable by the seed.</summary>
    Jittered,

    /// <summary>
    /// Points of Sobol's sequence in base 2, scrambled for each pixel: of 4, 16, 64, ... samples each row, each column and each cell of the grid holds as many.
    /// </summary>
    Sobol,
}
