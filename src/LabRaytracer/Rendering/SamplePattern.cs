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

    /// <summary>
    /// One random point in each cell of an n x n grid, such that each of n² rows and each of n² columns holds one too, repeatable by the seed (Chiu, Shirley and Wang 1994):
    /// less noise at edges that are almost upright or level.
    /// </summary>
    MultiJittered,
}
