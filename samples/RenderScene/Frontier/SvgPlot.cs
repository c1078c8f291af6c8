using System.Globalization;
using System.Text;

namespace RenderScene;

/// <summary>A plot with two logarithmic axes, as an SVG picture.</summary>
internal sealed class SvgPlot(string title, string xTitle, string yTitle)
{
    private const int Width = 640, Height = 420, Left = 76, Right = 170, Top = 40, Bottom = 52;

    private static readonly string[] s_colors = ["#0b62a4", "#c0392b", "#2e7d32", "#8e5ea2", "#d98200", "#00838f", "#6d4c41", "#546e7a", "#ad1457", "#9e9d24", "#000", "#999"];

    private readonly List<(string Name, List<(double X, double Y)> Points)> _lines = [];

    /// <summary>Adds a line; points that are not positive are left out.</summary>
    public void Add(string name, IEnumerable<(double X, double Y)> points)
    {
        List<(double X, double Y)> kept = [.. points.Where(point => point.X > 0 && point.Y > 0)];
        if (kept.Count > 0)
        {
            _lines.Add((name, kept));
        }
    }

    /// <summary>Writes the picture; without lines it writes none.</summary>
    public void Write(string path)
    {
        if (_lines.Count > 0)
        {
            File.WriteAllText(path, Draw());
        }
    }

    private string Draw()
    {
        LogAxis x = new(_lines.SelectMany(line => line.Points).Select(point => point.X), Left, Width - Right);
        LogAxis y = new(_lines.SelectMany(line => line.Points).Select(point => point.Y), Height - Bottom, Top);
        StringBuilder svg = new();
        Line(svg, $"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {Width} {Height}\" font-family=\"sans-serif\" font-size=\"12\">");
        Line(svg, $"<rect width=\"{Width}\" height=\"{Height}\" fill=\"white\"/><text x=\"{Left}\" y=\"22\" font-size=\"15\">{title}</text>");
        foreach (double mark in x.Marks)
        {
            Line(svg, $"<path d=\"M{x.At(mark):0.#} {Top}V{Height - Bottom}\" stroke=\"#ddd\"/><text x=\"{x.At(mark):0.#}\" y=\"{Height - Bottom + 18}\" text-anchor=\"middle\">{mark:G3}</text>");
        }

        foreach (double mark in y.Marks)
        {
            Line(svg, $"<path d=\"M{Left} {y.At(mark):0.#}H{Width - Right}\" stroke=\"#ddd\"/><text x=\"{Left - 8}\" y=\"{y.At(mark) + 4:0.#}\" text-anchor=\"end\">{mark:G3}</text>");
        }

        Line(svg, $"<text x=\"{(Left + Width - Right) / 2}\" y=\"{Height - 12}\" text-anchor=\"middle\">{xTitle}</text>");
        Line(svg, $"<text transform=\"translate(18 {(Top + Height - Bottom) / 2}) rotate(-90)\" text-anchor=\"middle\">{yTitle}</text>");
        for (int i = 0; i < _lines.Count; i++)
        {
            DrawLine(svg, i, x, y);
        }

        return svg.Append("</svg>\n").ToString();
    }

    private void DrawLine(StringBuilder svg, int number, LogAxis x, LogAxis y)
    {
        (string name, List<(double X, double Y)> points) = _lines[number];
        string color = s_colors[number % s_colors.Length];
        string path = string.Join(' ', points.Select(point => FormattableString.Invariant($"{x.At(point.X):0.#},{y.At(point.Y):0.#}")));
        Line(svg, $"<polyline points=\"{path}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>");
        foreach ((double px, double py) in points)
        {
            Line(svg, $"<circle cx=\"{x.At(px):0.#}\" cy=\"{y.At(py):0.#}\" r=\"3.5\" fill=\"{color}\"/>");
        }

        Line(svg, $"<text x=\"{Width - Right + 14}\" y=\"{Top + 14 + (20 * number)}\" fill=\"{color}\">{name}</text>");
    }

    private static void Line(StringBuilder svg, FormattableString line) => svg.Append(line.ToString(CultureInfo.InvariantCulture)).Append('\n');

    /// <summary>Places of numbers on a logarithmic axis of whole decades.</summary>
    private sealed class LogAxis
    {
        private readonly int _low, _high;
        private readonly double _from, _to;

        public LogAxis(IEnumerable<double> values, double from, double to)
        {
            (_from, _to) = (from, to);
            _low = (int)Math.Floor(Math.Log10(values.Min()));
            _high = Math.Max(_low + 1, (int)Math.Ceiling(Math.Log10(values.Max())));
        }

        public IEnumerable<double> Marks => Enumerable.Range(_low, _high - _low + 1).Select(power => Math.Pow(10, power));

        public double At(double value) => _from + ((_to - _from) * (Math.Log10(value) - _low) / (_high - _low));
    }
}
