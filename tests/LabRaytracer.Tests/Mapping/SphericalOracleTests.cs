using Xunit.Abstractions;

namespace LabRaytracer.Tests;

/// <summary>The spherical mapping against 60-digit results (Oracle/sphere.py): on and off the surface, poles, seam, axes, all magnitudes.</summary>
public sealed class SphericalOracleTests(ITestOutputHelper output)
{
    private const double BoundDouble = 1;
    private const double BoundFloat = 1;

    [Fact]
    public void Map_OracleRowsDouble_WithinBound() => Check<Double8>(BoundDouble);

    [Fact]
    public void Map_OracleRowsFloat_WithinBound() => Check<Float8>(BoundFloat);

    private void Check<R>(double bound)
        where R : unmanaged, IReal<R>
    {
        OracleRow[] rows = OracleRow.Read("sphere", 3, R.IsSingle);
        SurfacePosition[] points = [.. rows.Select(row => SurfacePosition.At(row.Inputs[0], row.Inputs[1], row.Inputs[2]))];
        (double[] u, double[] v) = WideMapping.Map<R>(new SphericalMapping(), points);
        double below = R.IsSingle ? MathF.BitDecrement(1) : Math.BitDecrement(1);
        var worst = new Dictionary<string, (double U, double V)>();
        for (int i = 0; i < rows.Length; i++)
        {
            // What would round to 1 is the largest number below 1.
            bool end = rows[i].Results[0].Nearest == 1;
            double errorU = end ? (u[i] == below ? 0 : 99) : UlpAssert.Error(u[i], rows[i].Results[0].Nearest, rows[i].Results[0].Left, R.IsSingle);
            double errorV = UlpAssert.Error(v[i], rows[i].Results[1].Nearest, rows[i].Results[1].Left, R.IsSingle);
            Assert.True(errorU <= bound && errorV <= bound, $"Row {i}, {rows[i].Name}, {points[i].LocalPoint}: got ({u[i]:R}, {v[i]:R}), wrong by {errorU}, {errorV} ulp.");
            Assert.InRange(u[i], 0, below);
            Assert.InRange(v[i], 0, 1);
            (double oldU, double oldV) = worst.GetValueOrDefault(rows[i].Name);
            worst[rows[i].Name] = (Math.Max(oldU, errorU), Math.Max(oldV, errorV));
        }

        foreach ((string name, (double U, double V) error) in worst)
        {
            output.WriteLine($"{typeof(R).Name} {name}: worst u {error.U:F2} ulp, v {error.V:F2} ulp");
        }
    }
}
