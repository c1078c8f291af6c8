using System.Globalization;

namespace LabRaytracer.Benchmarks;

/// <summary>All measured values; each is also appended to a CSV file at once, so that a run that is stopped leaves what it has.</summary>
internal sealed class Measures
{
    private readonly string _path;
    private readonly List<Measure> _all = [];

    public Measures(string path)
    {
        _path = path;
        File.WriteAllText(path, "scene,program,variant,quantity,value\n");
    }

    /// <summary>Measures in the order of their first values.</summary>
    public IReadOnlyList<Measure> All => _all;

    /// <summary>Adds a value.</summary>
    public void Add(string scene, string program, string variant, string quantity, double value)
    {
        Measure? measure = Find(scene, program, variant, quantity);
        if (measure is null)
        {
            measure = new Measure(scene, program, variant, quantity);
            _all.Add(measure);
        }

        measure.Add(value);
        File.AppendAllText(_path, string.Create(CultureInfo.InvariantCulture, $"{scene},{program},\"{variant}\",{quantity},{value:G6}\n"));
    }

    /// <summary>A measure, or null.</summary>
    public Measure? Find(string scene, string program, string variant, string quantity) =>
        _all.FirstOrDefault(measure => measure.Scene == scene && measure.Program == program && measure.Variant == variant && measure.Quantity == quantity);

    /// <summary>A median, or null.</summary>
    public double? Median(string scene, string program, string variant, string quantity) => Find(scene, program, variant, quantity)?.Median;
}
