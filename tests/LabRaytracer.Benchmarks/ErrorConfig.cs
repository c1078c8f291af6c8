using System.Globalization;
using System.Reflection;
using BenchmarkDotNet.Attributes;
using BenchmarkDotNet.Columns;
using BenchmarkDotNet.Configs;
using BenchmarkDotNet.Parameters;
using BenchmarkDotNet.Reports;
using BenchmarkDotNet.Running;

namespace LabRaytracer.Benchmarks;

/// <summary>Adds errors beside the time.</summary>
/// <typeparam name="T">The benchmarks.</typeparam>
public sealed class ErrorConfig<T> : ManualConfig
    where T : class, IMeasuresErrors, new()
{
    /// <summary>One column for each kind of error.</summary>
    public ErrorConfig()
    {
        Dictionary<string, IReadOnlyList<string>> known = [];
        for (int i = 0; i < T.ErrorNames.Count; i++)
        {
            AddColumn(new ErrorColumn(T.ErrorNames[i], i, known));
        }
    }

    /// <summary>Runs a method once, outside the clock, and asks for its errors.</summary>
    private static IReadOnlyList<string> Find(BenchmarkCase benchmarkCase)
    {
        T benchmarks = new();
        foreach (ParameterInstance parameter in benchmarkCase.Parameters.Items)
        {
            typeof(T).GetProperty(parameter.Name)!.SetValue(benchmarks, parameter.Value);
        }

        foreach (MethodInfo method in typeof(T).GetMethods().Where(method => method.GetCustomAttribute<GlobalSetupAttribute>() is not null))
        {
            method.Invoke(benchmarks, null);
        }

        return benchmarks.Errors(benchmarkCase.Descriptor.WorkloadMethod.Name);
    }

    private sealed class ErrorColumn(string name, int number, Dictionary<string, IReadOnlyList<string>> known) : IColumn
    {
        public string Id => nameof(ErrorColumn) + number.ToString(CultureInfo.InvariantCulture);

        public string ColumnName => name;

        public bool AlwaysShow => true;

        public ColumnCategory Category => ColumnCategory.Custom;

        public int PriorityInCategory => number;

        public bool IsNumeric => true;

        public UnitType UnitType => UnitType.Dimensionless;

        public string Legend => $"{name}: worst case of the benchmark's own input against a reference of higher precision";

        public string GetValue(Summary summary, BenchmarkCase benchmarkCase)
        {
            string key = benchmarkCase.Descriptor.WorkloadMethod.Name + benchmarkCase.Parameters.DisplayInfo;
            if (!known.TryGetValue(key, out IReadOnlyList<string>? errors))
            {
                known[key] = errors = Find(benchmarkCase);
            }

            return errors[number];
        }

        public string GetValue(Summary summary, BenchmarkCase benchmarkCase, SummaryStyle style) => GetValue(summary, benchmarkCase);

        public bool IsAvailable(Summary summary) => true;

        public bool IsDefault(Summary summary, BenchmarkCase benchmarkCase) => false;
    }
}
