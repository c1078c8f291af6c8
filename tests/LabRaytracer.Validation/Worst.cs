namespace LabRaytracer.Validation;

/// <summary>Keeps the largest error of a feature and where it was.</summary>
internal sealed class Worst(string feature, double bound, string unit)
{
    private readonly object _gate = new();
    private long _rows;
    private double _error;
    private string _example = "";

    /// <summary>Notes one error; NaN counts as infinite.</summary>
    public void Note(double error, FormattableString example)
    {
        error = double.IsNaN(error) ? double.PositiveInfinity : error;
        lock (_gate)
        {
            _rows++;
            if (error > _error)
            {
                _error = error;
                _example = FormattableString.Invariant(example);
            }
        }
    }

    /// <summary>Notes whether one input was treated right; faults add up.</summary>
    public void Count(bool isRight, FormattableString example)
    {
        lock (_gate)
        {
            _rows++;
            if (!isRight)
            {
                _error++;
                _example = FormattableString.Invariant(example);
            }
        }
    }

    /// <summary>The line of the table.</summary>
    public StressRow ToRow() => new(feature, _rows, _error, bound, unit, _example);
}
