using System.Globalization;
using System.Runtime.CompilerServices;

namespace LabRaytracer.Validation;

/// <summary>Keeps the largest error of a feature and where it was.</summary>
internal sealed class Worst(string feature, double bound, string unit)
{
    private readonly object _gate = new();
    private long _rows;
    private double _error;
    private string _example = "";

    /// <summary>What is allowed.</summary>
    public double Bound => bound;

    /// <summary>Notes one error; NaN counts as infinite.</summary>
    public void Note(double error, [InterpolatedStringHandlerArgument("", nameof(error))] ref Example example)
    {
        error = double.IsNaN(error) ? double.PositiveInfinity : error;
        lock (_gate)
        {
            _rows++;
            if (error > _error)
            {
                _error = error;
                _example = example.ToText();
            }
        }
    }

    /// <summary>Notes whether one input was treated right; faults add up.</summary>
    public void Count(bool isRight, [InterpolatedStringHandlerArgument(nameof(isRight))] ref Example example)
    {
        lock (_gate)
        {
            _rows++;
            if (!isRight)
            {
                _error++;
                _example = example.ToText();
            }
        }
    }

    /// <summary>The same feature, to be noted by one thread and added with <see cref="Add"/>.</summary>
    public Worst Part() => new(feature, bound, unit);

    /// <summary>Adds a part.</summary>
    /// <param name="part">What <see cref="Part"/> gave.</param>
    /// <param name="isCount">True if faults add up.</param>
    public void Add(Worst part, bool isCount)
    {
        lock (_gate)
        {
            _rows += part._rows;
            _example = part._error > (isCount ? 0 : _error) ? part._example : _example;
            _error = isCount ? _error + part._error : Math.Max(_error, part._error);
        }
    }

    /// <summary>The line of the table.</summary>
    public StressRow ToRow() => new(feature, _rows, _error, bound, unit, _example);

    /// <summary>Text that is only made for an input worth remembering.</summary>
    [InterpolatedStringHandler]
    public ref struct Example
    {
        private DefaultInterpolatedStringHandler _text;

        public Example(int literalLength, int formattedCount, Worst worst, double error, out bool isWanted)
            : this(literalLength, formattedCount, error <= worst._error, out isWanted)
        {
        }

        public Example(int literalLength, int formattedCount, bool isRight, out bool isWanted)
        {
            isWanted = !isRight;
            _text = isRight ? default : new DefaultInterpolatedStringHandler(literalLength, formattedCount, CultureInfo.InvariantCulture);
        }

        public void AppendLiteral(string text) => _text.AppendLiteral(text);

        public void AppendFormatted<T>(T value, string? format = null) => _text.AppendFormatted(value, format);

        public string ToText() => _text.ToStringAndClear();
    }
}
