namespace LabRaytracer;

/// <summary>Where samples lie in their pixels, one at a time; see <see cref="SampleAxis"/>.</summary>
internal static class SampleOffsets
{
    /// <summary>Position of a sample of an n x n grid along one axis, at random in its cell, [0, 1).</summary>
    /// <param name="options">Number of samples, seed.</param>
    /// <param name="pixelX">Column in the whole picture.</param>
    /// <param name="pixelY">Row in the whole picture.</param>
    /// <param name="sample">Number of the sample.</param>
    /// <param name="axis">0 for x, 1 for y.</param>
    public static double Jittered(RenderOptions options, int pixelX, int pixelY, int sample, int axis) =>
        new SampleAxis(options, SamplePattern.Jittered, sample, axis).At(pixelX, pixelY);

    /// <summary>Position of a multi-jittered sample of an n x n grid along one axis, [0, 1): inside of its cell in a row (a column) of n² of its own.</summary>
    /// <param name="options">Number of samples, seed.</param>
    /// <param name="pixelX">Column in the whole picture.</param>
    /// <param name="pixelY">Row in the whole picture.</param>
    /// <param name="sample">Number of the sample.</param>
    /// <param name="axis">0 for x, 1 for y.</param>
    public static double MultiJittered(RenderOptions options, int pixelX, int pixelY, int sample, int axis) =>
        new SampleAxis(options, SamplePattern.MultiJittered, sample, axis).At(pixelX, pixelY);

    /// <summary>Position of a sample of the regular pattern along one axis, (0, 1).</summary>
    public static double Regular(RenderOptions options, int sample, int axis) => new SampleAxis(options, SamplePattern.Regular, sample, axis).At(0, 0);

    /// <summary>Position of a sample of Sobol's sequence along one axis, [0, 1); the number of samples does not matter.</summary>
    public static double Sobol(RenderOptions options, int pixelX, int pixelY, int sample, int axis) =>
        new SampleAxis(options, SamplePattern.Sobol, sample, axis).At(pixelX, pixelY);

    /// <summary>Mixes the bits of a number, one to one (the finaliser of SplitMix64, Steele, Lea and Flood 2014).</summary>
    public static ulong Mix(ulong z)
    {
        z += 0x9E3779B97F4A7C15;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return z ^ (z >> 31);
    }
}
