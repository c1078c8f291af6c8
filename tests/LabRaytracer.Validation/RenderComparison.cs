using System.Globalization;

namespace LabRaytracer.Validation;

/// <summary>One scene rendered in each precision: what float saves and what it costs, what exact costs and what it changes.</summary>
/// <param name="Scene">Name of the scene.</param>
/// <param name="FloatTime">Time in float lanes divided by that in double lanes.</param>
/// <param name="FloatDifference">The float picture against the exact one.</param>
/// <param name="FloatWrong">Share of pixels of the float picture that are wrong.</param>
/// <param name="ExactTime">Time of the exact mode divided by that in double lanes.</param>
/// <param name="DoubleDifference">The double picture against the exact one.</param>
/// <param name="DoubleWrong">Share of pixels of the double picture that are wrong.</param>
internal sealed record RenderComparison(
    string Scene, double FloatTime, PictureDifference FloatDifference, double FloatWrong, double ExactTime, PictureDifference DoubleDifference, double DoubleWrong)
{
    private const int Repeats = 9;

    /// <summary>Head of the table.</summary>
    public const string Head = """
        | scene | float: time of double | float: RMSE | float: pixels wrong | exact: time of double | double: RMSE | double: pixels wrong |
        |---|---|---|---|---|---|---|

        """;

    /// <summary>Renders a scene in each precision, in turn, on one thread; the shortest time of each counts.</summary>
    public static RenderComparison Measure(string name, Scene scene, RenderOptions options)
    {
        Precision[] precisions = [Precision.Double, Precision.Single, Precision.Exact];
        double[] seconds = [double.PositiveInfinity, double.PositiveInfinity, double.PositiveInfinity];
        Picture[] pictures = new Picture[precisions.Length];
        for (int repeat = 0; repeat < Repeats; repeat++)
        {
            for (int i = 0; i < precisions.Length; i++)
            {
                RenderResult result = Renderer.Render(scene, With(options, precisions[i]));
                seconds[i] = Math.Min(seconds[i], result.Statistics.RenderSeconds);
                pictures[i] = result.Picture;
            }
        }

        return new RenderComparison(
            name,
            seconds[1] / seconds[0],
            PictureDifference.Compare(pictures[1], pictures[2]),
            Wrong(pictures[1], pictures[2]),
            seconds[2] / seconds[0],
            PictureDifference.Compare(pictures[0], pictures[2]),
            Wrong(pictures[0], pictures[2]));
    }

    /// <summary>The scene's line of the table.</summary>
    public string ToMarkdown() => string.Create(
        CultureInfo.InvariantCulture,
        $"| {Scene} | {FloatTime:0.00} | {Number(FloatDifference.Rmse)} | {Share(FloatWrong)} | {ExactTime:0.00} | {Number(DoubleDifference.Rmse)} | {Share(DoubleWrong)} |\n");

    /// <summary>Share of the pixels with a component whose 8-bit sRGB code differs by more than 1.</summary>
    public static double Wrong(Picture a, Picture b)
    {
        int wrong = 0;
        for (int pixel = 0; pixel < a.Pixels.Length; pixel++)
        {
            (Intensity x, Intensity y) = (a.Pixels[pixel], b.Pixels[pixel]);
            wrong += Codes(x.R, y.R) > 1 || Codes(x.G, y.G) > 1 || Codes(x.B, y.B) > 1 ? 1 : 0;
        }

        return (double)wrong / a.Pixels.Length;
    }

    private static int Codes(float a, float b) => Math.Abs(ColorEncoding.Srgb8FromLinear(Math.Clamp(a, 0, 1)) - ColorEncoding.Srgb8FromLinear(Math.Clamp(b, 0, 1)));

    private static RenderOptions With(RenderOptions options, Precision precision) =>
        new() { Width = options.Width, Height = options.Height, MaxDepth = options.MaxDepth, Threads = 1, Precision = precision };

    private static string Number(double value) => value.ToString(value == 0 ? "0" : "0.0e+0", CultureInfo.InvariantCulture);

    private static string Share(double value) => value == 0 ? "0" : (100 * value).ToString(value < 0.001 ? "0.000' %'" : "0.0' %'", CultureInfo.InvariantCulture);
}
