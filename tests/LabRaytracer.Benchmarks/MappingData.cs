using System.Numerics;
using System.Runtime.InteropServices;

namespace LabRaytracer.Benchmarks;

/// <summary>Points of the unit sphere in columns, of a fixed seed, and room for their coordinates.</summary>
internal sealed unsafe class MappingData<S>
    where S : unmanaged, IFloatingPointIeee754<S>
{
    public readonly S* X = Column(), Y = Column(), Z = Column(), U = Column(), V = Column();

    public MappingData()
    {
        var random = new Random(2009);
        for (int i = 0; i < MappingBenchmarks.Count; i++)
        {
            double y = (2 * random.NextDouble()) - 1, phi = Math.Tau * random.NextDouble(), radius = Math.Sqrt(1 - (y * y));
            (X[i], Y[i], Z[i]) = (S.CreateChecked(radius * Math.Sin(phi)), S.CreateChecked(y), S.CreateChecked(radius * Math.Cos(phi)));
        }
    }

    public void Map<R>(IWideMapping mapping)
        where R : unmanaged, IReal<R> =>
        mapping.Map(
            new PositionBatch<R> { X = (R*)X, Y = (R*)Y, Z = (R*)Z },
            new CoordinateBatch<R> { U = (R*)U, V = (R*)V },
            MappingBenchmarks.Count / R.Width);

    public double[] Results() => [.. Enumerable.Range(0, 2 * MappingBenchmarks.Count).Select(i => double.CreateChecked(i % 2 == 0 ? U[i / 2] : V[i / 2]))];

    /// <summary>Worst error of u and v, ulp of a significand of some digits.</summary>
    public double WorstUlp(int digits)
    {
        double worst = 0;
        for (int i = 0; i < MappingBenchmarks.Count; i++)
        {
            decimal x = DecimalAngles.Exact(double.CreateChecked(X[i])), y = DecimalAngles.Exact(double.CreateChecked(Y[i])), z = DecimalAngles.Exact(double.CreateChecked(Z[i]));
            double u = Ulps(x, z, double.CreateChecked(U[i]), DecimalAngles.Tau, digits);
            double v = Ulps(DecimalAngles.Sqrt((x * x) + (z * z)), -y, double.CreateChecked(V[i]), DecimalAngles.Tau / 2, digits);
            worst = Math.Max(worst, Math.Max(u, v));
        }

        return worst;
    }

    /// <summary>Error of a found angle, as a part of a turn or half turn, in ulp: the sine of its distance from the point's direction.</summary>
    private static double Ulps(decimal opposite, decimal adjacent, double found, decimal scale, int digits)
    {
        (decimal sin, decimal cos) = DecimalAngles.SinCos(DecimalAngles.Exact(found) * scale);
        decimal length = DecimalAngles.Sqrt((opposite * opposite) + (adjacent * adjacent));
        decimal difference = ((opposite * cos) - (adjacent * sin)) / length / scale;
        return Math.Abs((double)difference) / Math.ScaleB(1, Math.ILogB(found) + 1 - digits);
    }

    private static S* Column() => (S*)NativeMemory.AlignedAlloc((nuint)(MappingBenchmarks.Count * sizeof(S)), 64);
}
