using BenchmarkDotNet.Columns;
using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Reports;
using BenchmarkDotNet.Running;

namespace LabRaytracer.Benchmarks;

/// <summary>Adds the worst error beside the time.</summary>
public sealed class MappingConfig : ManualConfig
{
    public MappingConfig() => AddColumn(new UlpColumn());

    private sealed class UlpColumn : IColumn
    {
        private readonly MappingBenchmarks _benchmarks = new();

        public string Id => nameof(UlpColumn);

        public string ColumnName => "Ulp";

        public bool AlwaysShow => true;

        public ColumnCategory Category => ColumnCategory.Custom;

        public int PriorityInCategory => 0;

        public bool IsNumeric => true;

        public UnitType UnitType => UnitType.Dimensionless;

        public string Legend => "Worst error of u or v on the benchmark's points, ulp of its precision";

        public string GetValue(Summary summary, BenchmarkCase benchmarkCase) =>
            _benchmarks.WorstUlp(benchmarkCase.Descriptor.WorkloadMethod.Name).ToString("F2", System.Globalization.CultureInfo.InvariantCulture);

        public string GetValue(Summary summary, BenchmarkCase benchmarkCase, SummaryStyle style) => GetValue(summary, benchmarkCase);

        public bool IsAvailable(Summary summary) => true;

        public bool IsDefault(Summary summary, BenchmarkCase benchmarkCase) => false;
    }
}
