using System.Globalization;
using BenchmarkDotNet.Attributes;
using LabRaytracer.Validation;

namespace LabRaytracer.Benchmarks;

/// <summary>
/// 4096 rays against one shape, one thread, time per ray: one at a time, in groups of lanes, and with the surface point of every hit (which refines t).
/// The sphere's textbook formula (b² - 4ac in doubles) is the baseline. Half of the rays are generic, the others far away or grazing.
/// </summary>
[Config(typeof(ErrorConfig<IntersectionBenchmarks>))]
public class IntersectionBenchmarks : IMeasuresErrors
{
    internal const int Count = 4096;
    private const ulong Seed = 2009;
    private static readonly string[] s_kinds = ["generic", "generic", "far", "grazing"];

    private readonly double[] _found = new double[Count];
    private Shape _shape = null!;
    private Ray[] _rays = null!;
    private RayRun<Double16, Float16, Int16> _doubles = null!;
    private RayRun<Float16, Float16, Int16> _floats = null!;

    /// <summary>The shape.</summary>
    [Params("sphere", "cylinder", "plane", "disk", "quad", "box")]
    public string Shape { get; set; } = "sphere";

    /// <inheritdoc/>
    public static IReadOnlyList<string> ErrorNames => ["wrong hit or miss", "worst t, eps of the precision"];

    [GlobalSetup]
    public void Setup()
    {
        Draws draws = Draws.Of(Seed, Shape, 0);
        _shape = StressRays.Create(draws, Shape, "generic", out Point3D center, out double size);
        _rays = [.. Enumerable.Range(0, Count).Select(i => StressRays.At(draws, s_kinds[i % s_kinds.Length], center, size))];
        _doubles = new(_shape, Transform.Identity, _rays);
        _floats = new(_shape, Transform.Identity, _rays);
    }

    /// <summary>The formula of the textbooks; of the sphere only, the plain call of the shape for the others.</summary>
    [Benchmark(Baseline = true, OperationsPerInvoke = Count)]
    public void Textbook()
    {
        if (_shape is not Sphere sphere)
        {
            SingleCall();
            return;
        }

        for (int i = 0; i < Count; i++)
        {
            Vector3D o = _rays[i].Origin - sphere.Center, d = _rays[i].Direction;
            double a = Vector3D.Dot(d, d), b = 2 * Vector3D.Dot(o, d), c = Vector3D.Dot(o, o) - (sphere.Radius * sphere.Radius);
            double root = Math.Sqrt((b * b) - (4 * a * c)), near = (-b - root) / (2 * a), far = (-b + root) / (2 * a);
            _found[i] = near > 0 ? near : far > 0 ? far : double.NaN;
        }
    }

    /// <summary>The public door, one ray at a time.</summary>
    [Benchmark(OperationsPerInvoke = Count)]
    public void SingleCall()
    {
        for (int i = 0; i < Count; i++)
        {
            _found[i] = _shape.Intersect(_rays[i], double.PositiveInfinity, out Hit hit) ? hit.T : double.NaN;
        }
    }

    [Benchmark(OperationsPerInvoke = Count)]
    public void DoubleLanesNearest() => _doubles.Nearest();

    [Benchmark(OperationsPerInvoke = Count)]
    public void DoubleLanesNearestAndSurface()
    {
        _doubles.Nearest();
        _doubles.Surface();
    }

    [Benchmark(OperationsPerInvoke = Count)]
    public void FloatLanesNearest() => _floats.Nearest();

    /// <inheritdoc/>
    public IReadOnlyList<string> Errors(string method)
    {
        bool isSingle = method.StartsWith("Float", StringComparison.Ordinal);
        ((Action)Delegate.CreateDelegate(typeof(Action), this, method))();
        int wrong = 0;
        double worst = 0;
        for (int i = 0; i < Count; i++)
        {
            // Float lanes get rounded rays: a question of their own.
            ExactHit exact = ExactHit.Of(_shape, _rays[i]);
            double found = method.Contains("Lanes", StringComparison.Ordinal) ? Distance(isSingle, i) : _found[i];
            if (exact.Gap < (isSingle ? 1e-5 : 4e-15))
            {
                continue;
            }

            wrong += exact.IsHit == double.IsNaN(found) ? 1 : 0;
            worst = exact.IsHit && !double.IsNaN(found) ? Math.Max(worst, Math.Abs(((found - exact.T) / exact.T).ToDouble())) : worst;
        }

        return [wrong.ToString(CultureInfo.InvariantCulture), (worst * Math.ScaleB(1, isSingle ? 24 : 53)).ToString("G3", CultureInfo.InvariantCulture)];
    }

    private double Distance(bool isSingle, int ray) =>
        isSingle ? (_floats.IsHit(ray) ? _floats.Distance(ray) : double.NaN) : _doubles.IsHit(ray) ? _doubles.Distance(ray) : double.NaN;
}
