using System.Globalization;
using System.Text;

namespace RenderScene;

/// <summary>Time against error as CSV, SVG and Markdown.</summary>
internal static class FrontierReport
{
    /// <summary>Writes NAME.csv, NAME.svg and NAME.md into a folder.</summary>
    /// <param name="folder">The folder; made if it is not there.</param>
    /// <param name="name">Name of the files.</param>
    /// <param name="title">Title of plot and table.</param>
    /// <param name="remark">What was done, a sentence or two.</param>
    /// <param name="points">The points.</param>
    public static void Write(string folder, string name, string title, string remark, IReadOnlyList<FrontierPoint> points)
    {
        Directory.CreateDirectory(folder);
        StringBuilder table = new(), values = new("series,variant,seconds,rmse,innerRmse\n");
        Line(table, $"# {title}\n\n{remark}\n\n![time against error]({name}.svg)\n\n| way | how | seconds | RMSE | inside objects | |\n|---|---|---|---|---|---|");
        foreach (FrontierPoint point in points)
        {
            string mark = points.Any(other => IsBetter(other, point)) ? "" : "frontier";
            Line(table, $"| {point.Series} | {point.Variant} | {point.Seconds:0.0000} | {point.Rmse:0.00000} | {point.InnerRmse:0.00000} | {mark} |");
            Line(values, $"{Quoted(point.Series)},{Quoted(point.Variant)},{point.Seconds:G6},{point.Rmse:G6},{point.InnerRmse:G6}");
        }

        File.WriteAllText(Path.Combine(folder, $"{name}.md"), table.ToString());
        File.WriteAllText(Path.Combine(folder, $"{name}.csv"), values.ToString());
        SvgPlot plot = new(title, "seconds, one thread", "RMSE against the converged picture");
        foreach (IGrouping<string, FrontierPoint> series in points.GroupBy(point => point.Series))
        {
            plot.Add(series.Key, series.Select(point => (point.Seconds, point.Rmse)));
        }

        plot.Write(Path.Combine(folder, $"{name}.svg"));
    }

    private static bool IsBetter(FrontierPoint a, FrontierPoint b) =>
        a.Seconds <= b.Seconds && a.Rmse <= b.Rmse && (a.Seconds < b.Seconds || a.Rmse < b.Rmse);

    private static string Quoted(string text) => $"\"{text}\"";

    private static void Line(StringBuilder text, FormattableString line) => text.Append(line.ToString(CultureInfo.InvariantCulture)).Append('\n');
}
