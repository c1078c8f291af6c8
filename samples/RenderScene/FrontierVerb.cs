using System.CommandLine;
using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>frontier SCENE: time against error over filters, precisions, samples and error budgets.</summary>
internal sealed class FrontierVerb
{
    private readonly Argument<string> _scene = new("scene") { Description = "The scene file." };

    private readonly Option<string?> _size = new("--size") { HelpName = "WxH", Description = "Size of the pictures. Default: 320x180." };

    private readonly Option<string?> _samples = new("--reference-samples") { HelpName = "N", Description = "Samples a pixel of the converged picture, a square. Default: 4096." };

    private readonly Option<string?> _output = new("--output", "-o") { HelpName = "FOLDER", Description = "Where CSV, SVG and Markdown go. Default: out." };

    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console, CancellationToken stop)
    {
        FrontierVerb verb = new();
        Command command = new("frontier", "Renders a scene in many ways and writes time against error as CSV, SVG and Markdown.") { verb._scene, verb._size, verb._samples, verb._output };
        command.SetAction(parsed => verb.Run(parsed, console, stop));
        return command;
    }

    private int Run(ParseResult parsed, AppConsole console, CancellationToken stop)
    {
        int[] size = parsed.GetValue(_size) is { } text ? OptionText.Integers("--size", text, 'x', "WxH") : [320, 180];
        if (size.Any(side => side is < 1 or > 4096))
        {
            throw new UsageException($"--size {size[0]}x{size[1]} is not possible here: 1 to 4096 pixels a side.");
        }

        int samples = parsed.GetValue(_samples) is { } number ? Samples(number) : 4096;
        string path = parsed.GetRequiredValue(_scene), folder = parsed.GetValue(_output) ?? "out", name = Path.GetFileNameWithoutExtension(path);
        PictureOutput.MakeFolder(folder);
        FrontierSweep sweep = new(SceneInput.Load(path), size[0], size[1]);
        Picture converged = sweep.Converged(samples, path, Path.Combine(folder, "converged"), stop);
        List<FrontierPoint> points = sweep.Run(
            converged,
            point => console.Error.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{point.Series,-22} {point.Variant,-22} {point.Seconds,9:0.0000} s   RMSE {point.Rmse:0.00000}, inside objects {point.InnerRmse:0.00000}")),
            stop);
        string remark = string.Create(
            CultureInfo.InvariantCulture, $"{size[0]} x {size[1]} pixels, one thread, the shortest of three renders; errors of linear light against {samples} samples a pixel, of all pixels and of those that no edge of an object crosses.");
        FrontierReport.Write(folder, $"{name}-frontier", $"{name}: time against error", remark, points);
        console.Output.WriteLine(Path.Combine(folder, $"{name}-frontier.md"));
        return ExitCode.Done;
    }

    private static int Samples(string text)
    {
        int samples = OptionText.Integer("--reference-samples", text, 1, 65536), side = (int)Math.Sqrt(samples);
        return side * side == samples ? samples : throw new UsageException($"--reference-samples {samples} is not a square; near it is {side * side}.");
    }
}
