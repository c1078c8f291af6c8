using System.Globalization;

namespace LabRaytracer.Validation;

/// <summary>One line of the error table: what was measured, how often, how wrong at worst, and what is allowed.</summary>
/// <param name="Feature">What was measured.</param>
/// <param name="Rows">How many inputs.</param>
/// <param name="Worst">Largest error, or number of faults.</param>
/// <param name="Bound">What is allowed, the end included.</param>
/// <param name="Unit">Unit of both.</param>
/// <param name="Example">The input of the largest error.</param>
internal sealed record StressRow(string Feature, long Rows, double Worst, double Bound, string Unit, string Example = "")
{
    /// <summary>True if the bound holds, and something was measured.</summary>
    public bool IsKept => Rows > 0 && Worst <= Bound;

    /// <summary>"ok" or "BREACH".</summary>
    public string Verdict => IsKept ? "ok" : "BREACH";

    /// <summary>Worst error with three digits.</summary>
    public string WorstText => Text(Worst);

    /// <summary>The bound with its unit.</summary>
    public string BoundText => Bound == 0 ? Unit == "" ? "0" : $"0 {Unit}" : $"{Text(Bound)} {Unit}";

    private static string Text(double value) => value.ToString(value is 0 or >= 0.001 and < 1e6 ? "0.###" : "0.##e+0", CultureInfo.InvariantCulture);
}
