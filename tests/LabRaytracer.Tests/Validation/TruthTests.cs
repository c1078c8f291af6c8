using LabRaytracer.Tests;

namespace LabRaytracer.Validation.Tests;

/// <summary>The oracle of the sweeps against rows made by mpmath at 60 digits (Oracle/functions.py, Oracle/sphere.py).</summary>
public sealed class TruthTests
{
    /// <summary>The rows give the exact result as a number and a rest of three decimals of an ulp.</summary>
    private const double Rounding = 0.00051;

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Functions_OracleRows_Agree(bool isSingle)
    {
        int checkedRows = 0;
        foreach (OracleRow row in OracleRow.Read("functions", 2, isSingle))
        {
            if (Exact(row.Name, row.Inputs[0], row.Inputs[1]) is { } exact)
            {
                Check(row.Results[0], exact, isSingle, row.ToString());
                checkedRows++;
            }
        }

        Assert.InRange(checkedRows, 800, 2000);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Sphere_OracleRows_Agree(bool isSingle) => Assert.All(OracleRow.Read("sphere", 3, isSingle), row =>
    {
        if (row.Inputs.All(double.IsFinite))
        {
            (Real u, Real v) = Truth.Sphere(row.Inputs[0], row.Inputs[1], row.Inputs[2]);
            Check(row.Results[0], u, isSingle, row.ToString());
            Check(row.Results[1], v, isSingle, row.ToString());
        }
    });

    [Theory]
    [InlineData(2, 1.4142135623730951, -0.4354)]
    [InlineData(3, 1.7320508075688772, 0.4519)]
    public void Sqrt_OfSmallNumbers_MatchesMpmath(double a, double nearest, double rest) =>
        Assert.Equal(rest, ((Real.Sqrt(a) - nearest) * Math.ScaleB(1, 52)).ToDouble(), 1e-3);

    private static void Check((double Nearest, double Left) expected, Real exact, bool isSingle, string row)
    {
        double rest = Truth.Ulps(expected.Nearest, exact, isSingle) * (exact - expected.Nearest).Sign;
        Assert.True(Math.Abs(rest - expected.Left) < Rounding, $"{row}: the rest is {rest} ulp, not {expected.Left}.");
    }

    private static Real? Exact(string name, double x, double y) => name switch
    {
        "sin" => Truth.SinCosTurns(x).Sin,
        "cos" => Truth.SinCosTurns(x).Cos,
        "exp2" => Truth.Exp2(x),
        "log2" => Truth.Log2(x),
        "pow" => Truth.Pow(x, y),
        "hypot" => Truth.Hypotenuse(x, y),
        _ => null,
    };
}
