using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>figure N: the figures of the lab sheet, made by this library.</summary>
internal static class FigureVerb
{
    private static readonly (string Title, Func<FigureTools, Picture> Draw)[] s_figures =
    [
        ("the advantages of texturing: without and with textures", MaterialFigures.Advantages),
        ("a texture on each coefficient of a material", MaterialFigures.Slots),
        ("texture coordinates (u, v) and texel coordinates (x_p, y_p)", PlaneFigures.Axes),
        ("cylindrical mapping", SurfaceFigures.Cylinder),
        ("texturing a sphere: it cannot be wrapped in a flat sheet", SurfaceFigures.Wrapped),
        ("a point p on the unit sphere and in the picture", SurfaceFigures.Sphere),
        ("the grid for covering a sphere", PlaneFigures.Grid),
        ("the grid mapped onto the sphere", SurfaceFigures.Grid),
    ];

    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console, CancellationToken stop)
    {
        Argument<string> number = new("number") { Description = $"Which figure of the lab sheet, 1 to {s_figures.Length}." };
        Option<string?> output = new("--output", "-o") { HelpName = "FILE", Description = "The picture. Default: out/figure-N.png." };
        Option<string?> width = new("--width") { HelpName = "N", Description = "Width of the figure, pixels, 320 to 8192. Default: 1280." };
        Option<bool> quiet = new("--quiet", "-q") { Description = "No progress and no summary." };
        Command command = new("figure", "Draws a figure of the lab sheet again.") { number, output, width, quiet };
        command.SetAction(parsed =>
        {
            int n = OptionText.Integer("figure", parsed.GetRequiredValue(number), 1, s_figures.Length);
            int columns = OptionText.Integer("--width", parsed.GetValue(width) ?? "1280", 320, 8192);
            string path = parsed.GetValue(output) ?? PictureOutput.DefaultPath(string.Create(CultureInfo.InvariantCulture, $"figure-{n}.png"));
            return Run(n, columns, path, parsed.GetValue(quiet) ? console with { Progress = ProgressStyle.None, Output = TextWriter.Null } : console, stop);
        });
        return command;
    }

    private static int Run(int number, int width, string path, AppConsole console, CancellationToken stop)
    {
        PictureOutput.Check(path);
        Stopwatch clock = Stopwatch.StartNew();
        (string title, Func<FigureTools, Picture> draw) = s_figures[number - 1];
        string name = string.Create(CultureInfo.InvariantCulture, $"figure {number}");
        Picture picture = ProgressDisplay.Run(console, name, progress => draw(new FigureTools(width, progress, stop)));
        PictureSaveOptions options = PictureOutput.WithText(PictureSaveOptions.Default, new("Title", $"{name}: {title}"), new("Software", $"LabRaytracer {VersionVerb.Version}"));
        PictureOutput.Save(picture, path, options, stop);
        console.Output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{path}: {name}, {title}; {clock.Elapsed.TotalSeconds:0.00} s"));
        return ExitCode.Done;
    }
}
