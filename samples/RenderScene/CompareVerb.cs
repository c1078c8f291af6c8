using System.CommandLine;
using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>compare A B: how much two pictures differ.</summary>
internal sealed class CompareVerb
{
    private static readonly Dictionary<string, Func<PictureDifference, double>> s_metrics = new()
    {
        ["rmse"] = difference => difference.Rmse,
        ["psnr"] = difference => difference.Psnr,
        ["max"] = difference => difference.Max,
        ["ssim"] = difference => difference.Ssim,
    };

    private readonly Argument<string> _first = new("a") { Description = "One picture." };

    private readonly Argument<string> _second = new("b") { Description = "The other picture, of the same size." };

    private readonly Option<string?> _metric = new("--metric")
    {
        HelpName = "rmse|psnr|max|ssim", Description = "Print this number alone, and check it. Default: print all, check rmse.",
    };

    private readonly Option<string?> _heatmap = new("--heatmap") { HelpName = "FILE", Description = "Write a picture of where the differences are." };

    private readonly Option<string?> _failAbove = new("--fail-above")
    {
        HelpName = "X", Description = "Exit with 1 if the pictures differ more than this: rmse or max above X; psnr or ssim, where more is better, below X.",
    };

    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console)
    {
        CompareVerb verb = new();
        Command command = new("compare", "Measures how much two pictures differ, as they are displayed: sRGB, 0 to 1.")
        {
            verb._first, verb._second, verb._metric, verb._heatmap, verb._failAbove,
        };
        command.SetAction(parsed => verb.Run(parsed, console));
        return command;
    }

    private int Run(ParseResult parsed, AppConsole console)
    {
        string? metric = parsed.GetValue(_metric);
        string word = metric?.ToLowerInvariant() ?? "rmse";
        Func<PictureDifference, double> measure = OptionText.Word("--metric", word, s_metrics);
        double? limit = parsed.GetValue(_failAbove) is { } text ? OptionText.NotNegative("--fail-above", text) : null;
        string? heatmap = parsed.GetValue(_heatmap);
        if (heatmap is not null)
        {
            PictureOutput.Check(heatmap);
        }

        PictureDifference difference = Compare(parsed.GetRequiredValue(_first), parsed.GetRequiredValue(_second));
        foreach ((string name, Func<PictureDifference, double> value) in s_metrics)
        {
            if (metric is null || name == word)
            {
                console.Output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{name} {value(difference):0.########}"));
            }
        }

        if (heatmap is not null)
        {
            difference.CreateHeatMap().Save(heatmap);
        }

        return limit is { } most && IsWorse(word, measure(difference), most) ? ExitCode.CheckFailed : ExitCode.Done;
    }

    private static bool IsWorse(string metric, double value, double limit) => metric is "psnr" or "ssim" ? value < limit : value > limit;

    private static Picture Load(string path) => Directory.Exists(path)
        ? throw new InputException($"'{path}' is a folder; name a picture in it.")
        : Picture.Load(path);

    private static PictureDifference Compare(string first, string second)
    {
        Picture a = Load(first), b = Load(second);
        return a.Width == b.Width && a.Height == b.Height
            ? PictureDifference.Compare(a, b)
            : throw new InputException($"'{first}' is {a.Width} x {a.Height} pixels, '{second}' is {b.Width} x {b.Height}; only pictures of one size can be compared.");
    }
}
