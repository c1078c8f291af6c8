using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Configs;

namespace LabRaytracer.Benchmarks;

/// <summary>The million-triangle torus: building its tree on one and two threads, and camera rays on one thread (time is per ray).</summary>
[GroupBenchmarksBy(BenchmarkLogicalGroupRule.ByCategory)]
[CategoriesColumn]
public class BvhBenchmarks
{
    // 120 x 68 blocks of 16 rays.
    private const int Rays = 130560;
    private TriangleMesh _mesh = null!;
    private BvhStream<Double16, Float16, Int16> _doubles16 = null!;
    private BvhStream<Double8, Float8, Int8> _doubles8 = null!;
    private BvhStream<Float16, Float16, Int16> _floats16 = null!;
    private BvhStream<Float8, Float8, Int8> _floats8 = null!;

    [GlobalSetup]
    public void Setup()
    {
        if (BvhStream<Double16, Float16, Int16>.Count != Rays)
        {
            throw new InvalidOperationException($"The stream has {BvhStream<Double16, Float16, Int16>.Count} rays; the time per ray is divided by {Rays}.");
        }

        _mesh = BvhTorus.Mesh();
        _doubles16 = new(_mesh);
        _doubles8 = new(_mesh);
        _floats16 = new(_mesh);
        _floats8 = new(_mesh);
        Console.WriteLine($"// {_mesh.Bytes / (double)_mesh.TriangleCount:F1} bytes a triangle");
    }

    [Benchmark(Baseline = true), BenchmarkCategory("build")]
    public long BuildOneThread() => new MeshTree(_mesh.Data, null, _mesh.Bounds, 1).Bytes;

    [Benchmark, BenchmarkCategory("build")]
    public long BuildTwoThreads() => new MeshTree(_mesh.Data, null, _mesh.Bounds, 2).Bytes;

    [Benchmark(Baseline = true, OperationsPerInvoke = Rays), BenchmarkCategory("primary rays")]
    public void NearestFloat16() => _floats16.Nearest();

    [Benchmark(OperationsPerInvoke = Rays), BenchmarkCategory("primary rays")]
    public void NearestDouble16() => _doubles16.Nearest();

    [Benchmark(OperationsPerInvoke = Rays), BenchmarkCategory("primary rays")]
    public void NearestFloat8() => _floats8.Nearest();

    [Benchmark(OperationsPerInvoke = Rays), BenchmarkCategory("primary rays")]
    public void NearestDouble8() => _doubles8.Nearest();
}
