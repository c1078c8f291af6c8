namespace LabRaytracer.Benchmarks;

/// <summary>Benchmarks that know the error of what they compute.</summary>
public interface IMeasuresErrors
{
    /// <summary>What the columns of errors are called, one after the other.</summary>
    static abstract IReadOnlyList<string> ErrorNames { get; }

    /// <summary>Worst errors of a method with the parameters that are set now, as they are printed.</summary>
    /// <param name="method">Name of the benchmark's method.</param>
    IReadOnlyList<string> Errors(string method);
}
