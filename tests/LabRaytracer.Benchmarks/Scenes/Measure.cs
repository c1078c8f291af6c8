namespace LabRaytracer.Benchmarks;

/// <summary>One measured quantity: who, what, on which scene; the values of all rounds.</summary>
/// <param name="Scene">The scene, or the sweep and its size.</param>
/// <param name="Program">Who: "LabRaytracer" or "POV-Ray".</param>
/// <param name="Variant">How: threads, precision, options.</param>
/// <param name="Quantity">What: "picture", "process", ... in seconds, or "rmse", "peak MB".</param>
internal sealed record Measure(string Scene, string Program, string Variant, string Quantity)
{
    private readonly List<double> _values = [];

    /// <summary>Values in the order of the rounds.</summary>
    public IReadOnlyList<double> Values => _values;

    /// <summary>The middle value; the mean of the two middle ones.</summary>
    public double Median
    {
        get
        {
            double[] sorted = [.. _values.Order()];
            return (sorted[(sorted.Length - 1) / 2] + sorted[sorted.Length / 2]) / 2;
        }
    }

    /// <summary>Adds the value of a round.</summary>
    public void Add(double value) => _values.Add(value);
}
