using System.Globalization;
using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;

namespace LabRaytracer.Benchmarks;

/// <summary>
/// The spherical mapping, 4096 points of the unit sphere in cache, one thread: generic lanes against hand-written registers at each width,
/// one point at a time, and the plain loop of Math.Acos and Math.Atan2. The column ulp is the worst error of u or v on these points.
/// </summary>
[GroupBenchmarksBy(BenchmarkLogicalGroupRule.ByCategory)]
[CategoriesColumn]
[Config(typeof(ErrorConfig<MappingBenchmarks>))]
public unsafe class MappingBenchmarks : IMeasuresErrors
{
    internal const int Count = 4096;
    private readonly MappingData<double> _double = new();
    private readonly MappingData<float> _float = new();
    private readonly SphericalMapping _mapping = new();

    [GlobalSetup]
    public void Setup()
    {
        // A comparison of unequal results would be worthless.
        Check(DoubleLanes4, DoubleRegisters256, _double.Results);
        Check(DoubleLanes16, DoubleRegisters512, _double.Results);
        Check(FloatLanes4, FloatRegisters128, _float.Results);
        Check(FloatLanes8, FloatRegisters256, _float.Results);
        Check(FloatLanes16, FloatRegisters512, _float.Results);
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = Count), BenchmarkCategory("double, one point")]
    public void MathAcosAtan2()
    {
        MappingData<double> d = _double;
        for (int i = 0; i < Count; i++)
        {
            double phi = Math.Atan2(d.X[i], d.Z[i]);
            d.U[i] = (phi < 0 ? phi + Math.Tau : phi) / Math.Tau;
            d.V[i] = 1 - (Math.Acos(d.Y[i]) / Math.PI);
        }
    }

    [Benchmark(OperationsPerInvoke = Count), BenchmarkCategory("double, one point")]
    public void SingleCall()
    {
        MappingData<double> d = _double;
        for (int i = 0; i < Count; i++)
        {
            TextureCoordinate coordinate = _mapping.Map(new Point3D(d.X[i], d.Y[i], d.Z[i]));
            (d.U[i], d.V[i]) = (coordinate.U, coordinate.V);
        }
    }

    [Benchmark(OperationsPerInvoke = Count), BenchmarkCategory("double, one point")]
    public void DoubleLanes1() => _double.Map<Double1>(_mapping);

    [Benchmark(Baseline = true, OperationsPerInvoke = Count), BenchmarkCategory("double, 256 bits")]
    public void DoubleRegisters256() => HandWrittenDouble256.Map(_double.X, _double.Y, _double.Z, _double.U, _double.V, Count);

    [Benchmark(OperationsPerInvoke = Count), BenchmarkCategory("double, 256 bits")]
    public void DoubleLanes4() => _double.Map<Double4>(_mapping);

    [Benchmark(OperationsPerInvoke = Count), BenchmarkCategory("double, 256 bits")]
    public void DoubleLanes8() => _double.Map<Double8>(_mapping);

    [Benchmark(Baseline = true, OperationsPerInvoke = Count), BenchmarkCategory("double, 512 bits")]
    public void DoubleRegisters512() => HandWrittenDouble512.Map(_double.X, _double.Y, _double.Z, _double.U, _double.V, Count);

    [Benchmark(OperationsPerInvoke = Count), BenchmarkCategory("double, 512 bits")]
    public void DoubleLanes16() => _double.Map<Double16>(_mapping);

    [Benchmark(Baseline = true, OperationsPerInvoke = Count), BenchmarkCategory("float, 128 bits")]
    public void FloatRegisters128() => HandWrittenSingle128.Map(_float.X, _float.Y, _float.Z, _float.U, _float.V, Count);

    [Benchmark(OperationsPerInvoke = Count), BenchmarkCategory("float, 128 bits")]
    public void FloatLanes4() => _float.Map<Float4>(_mapping);

    [Benchmark(Baseline = true, OperationsPerInvoke = Count), BenchmarkCategory("float, 256 bits")]
    public void FloatRegisters256() => HandWrittenSingle256.Map(_float.X, _float.Y, _float.Z, _float.U, _float.V, Count);

    [Benchmark(OperationsPerInvoke = Count), BenchmarkCategory("float, 256 bits")]
    public void FloatLanes8() => _float.Map<Float8>(_mapping);

    [Benchmark(Baseline = true, OperationsPerInvoke = Count), BenchmarkCategory("float, 512 bits")]
    public void FloatRegisters512() => HandWrittenSingle512.Map(_float.X, _float.Y, _float.Z, _float.U, _float.V, Count);

    [Benchmark(OperationsPerInvoke = Count), BenchmarkCategory("float, 512 bits")]
    public void FloatLanes16() => _float.Map<Float16>(_mapping);

    /// <inheritdoc/>
    public static IReadOnlyList<string> ErrorNames => ["ulp"];

    /// <summary>Worst error of u or v on the points, ulp of the method's precision, against angles of 28 digits.</summary>
    /// <inheritdoc/>
    public IReadOnlyList<string> Errors(string method)
    {
        ((Action)Delegate.CreateDelegate(typeof(Action), this, method))();
        double ulp = method.StartsWith("Float", StringComparison.Ordinal) ? _float.WorstUlp(24) : _double.WorstUlp(53);
        return [ulp.ToString("F2", CultureInfo.InvariantCulture)];
    }

    private static void Check(Action first, Action second, Func<double[]> results)
    {
        first();
        double[] expected = results();
        second();
        if (!expected.AsSpan().SequenceEqual(results()))
        {
            throw new InvalidOperationException($"{first.Method.Name} and {second.Method.Name} differ: the hand-written kernel must compute the same formula.");
        }
    }
}
