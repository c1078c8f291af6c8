using Xunit.Abstractions;

namespace LabRaytracer.Tests;

/// <summary>Elementary functions against 60-digit results (Oracle/functions.py).</summary>
public sealed class ElementaryOracleTests(ITestOutputHelper output)
{
    [Theory]
    [InlineData("sin", 1.5)]
    [InlineData("cos", 1.5)]
    [InlineData("exp2", 1.5)]
    [InlineData("log2", 1.5)]
    [InlineData("hypot", 1)]
    [InlineData("pow", 32)]
    public void Function_OracleRowsDouble_WithinBound(string name, double bound) => Check<Double8>(name, bound);

    [Theory]
    [InlineData("sin", 1.5)]
    [InlineData("cos", 1.5)]
    [InlineData("exp2", 1.5)]
    [InlineData("log2", 1.5)]
    [InlineData("hypot", 1)]
    [InlineData("pow", 4)]
    public void Function_OracleRowsFloat_WithinBound(string name, double bound) => Check<Float8>(name, bound);

    [Theory]
    [InlineData("sindeg", 1.5)]
    [InlineData("cosdeg", 1.5)]
    [InlineData("tandeg", 3)]
    public void Degrees_OracleRows_WithinBound(string name, double bound) => Compare(name, bound, false, (a, _) => [.. a.Select(degrees => name switch
    {
        "sindeg" => Elementary.SinCosDegrees(degrees).Sin,
        "cosdeg" => Elementary.SinCosDegrees(degrees).Cos,
        _ => Elementary.TanDegrees(degrees),
    })]);

    private static R Evaluate<R>(string name, R a, R b)
        where R : unmanaged, IReal<R> => name switch
        {
            "sin" => Elementary.SinCosTurns(a).Sin,
            "cos" => Elementary.SinCosTurns(a).Cos,
            "exp2" => Elementary.Exp2(a),
            "log2" => Elementary.Log2(a),
            "hypot" => Elementary.Hypotenuse(a, b),
            _ => Elementary.Pow(a, b),
        };

    private void Check<R>(string name, double bound)
        where R : unmanaged, IReal<R> =>
        Compare(name, bound, R.IsSingle, (a, b) => WideMapping.Apply<R>((x, y) => Evaluate(name, x, y), a, b));

    private void Compare(string name, double bound, bool single, Func<double[], double[], double[]> function)
    {
        OracleRow[] rows = [.. OracleRow.Read("functions", 2, single).Where(row => row.Name == name)];
        Assert.True(rows.Length > 100);
        double[] results = function([.. rows.Select(row => row.Inputs[0])], [.. rows.Select(row => row.Inputs[1])]);
        double worst = 0;
        for (int i = 0; i < rows.Length; i++)
        {
            double error = UlpAssert.Error(results[i], rows[i].Results[0].Nearest, rows[i].Results[0].Left, single);
            Assert.True(error <= bound, $"{name}({rows[i].Inputs[0]:R}, {rows[i].Inputs[1]:R}) = {results[i]:R}, expected {rows[i].Results[0].Nearest:R}: {error} ulp.");
            worst = Math.Max(worst, error);
        }

        output.WriteLine($"{name}, {(single ? "float" : "double")}: worst {worst:F2} ulp of {rows.Length} rows");
    }
}
