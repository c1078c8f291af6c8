using System.Globalization;

namespace LabRaytracer.Tests.Texturing;

/// <summary>Lattice noises and cell distances against exact arithmetic (Oracle/noise.py).</summary>
public sealed class PatternOracleTests
{
    /// <summary>Fractions are rounded to float once, then about twenty float operations on numbers of size 1 follow, times the slope of the pattern.</summary>
    private const double Bound = 2e-6;

    private static readonly string[][] s_rows =
        [.. File.ReadLines(Path.Combine(AppContext.BaseDirectory, "Oracle", "patterns.txt")).Where(line => line[0] != '#').Select(line => line.Split(' '))];

    [Theory]
    [InlineData(NoiseKind.Gradient)]
    [InlineData(NoiseKind.Value)]
    [InlineData(NoiseKind.Cubic)]
    [InlineData(NoiseKind.Simplex)]
    public void Noise_OracleRows_WithinBound(NoiseKind kind)
    {
        string[][] rows = [.. s_rows.Where(row => row[0].Equals(kind.ToString(), StringComparison.OrdinalIgnoreCase))];
        Assert.Equal(64, rows.Length);
        foreach (string[] row in rows)
        {
            var noise = new Noise { Kind = kind, Octaves = int.Parse(row[1], CultureInfo.InvariantCulture), Sum = Enum.Parse<NoiseSum>(row[2], ignoreCase: true), Seed = (int)Number(row[3]) };
            Assert.Equal(Number(row[7]), noise.At(Point(row)), Bound);
        }
    }

    [Theory]
    [InlineData(WorleyMetric.Euclidean)]
    [InlineData(WorleyMetric.Manhattan)]
    [InlineData(WorleyMetric.Chebyshev)]
    public void Worley_OracleRows_WithinBound(WorleyMetric metric)
    {
        string[][] rows = [.. s_rows.Where(row => row[0].Equals(metric.ToString(), StringComparison.OrdinalIgnoreCase))];
        Assert.Equal(48, rows.Length);
        foreach (string[] row in rows)
        {
            double Distance(WorleyFeature feature)
            {
                bool isFlat = row[1] == "1";
                var texture = new WorleyTexture
                {
                    Metric = metric, Feature = feature, Frequency = 1, Seed = (int)Number(row[3]), FilterWidth = 0,
                    Space = isFlat ? PatternSpace.Uv : PatternSpace.Local, Ramp = new ColorRamp(new ColorStop(0, Intensity.Black), new ColorStop(4, Intensity.Grey(4))),
                };
                Point3D p = Point(row);
                return texture.Sample(isFlat ? TextureLookup.At(p.X, p.Y) : TextureLookup.At(p)).R;
            }

            double first = Number(row[7]), second = Number(row[8]);
            Assert.Equal(first, Distance(WorleyFeature.F1), Bound);
            Assert.Equal(second, Distance(WorleyFeature.F2), Bound);
            Assert.Equal(second - first, Distance(WorleyFeature.F2MinusF1), Bound);
        }
    }

    private static double Number(string word) => double.Parse(word, CultureInfo.InvariantCulture);

    private static Point3D Point(string[] row) => new(Number(row[4]), Number(row[5]), Number(row[6]));
}
