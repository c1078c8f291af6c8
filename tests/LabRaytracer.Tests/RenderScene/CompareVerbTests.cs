using RenderScene;

namespace LabRaytracer.Tests.Samples;

public sealed class CompareVerbTests
{
    [Fact]
    public void Compare_EqualPictures_HaveNoDifference()
    {
        using TestFolder folder = new();
        string a = Write(folder, "a.png", Intensity.Grey(0.5f));
        Assert.Equal(new ProgramRun(ExitCode.Done, "rmse 0\npsnr Infinity\nmax 0\nssim 1\n", ""), ProgramRun.Of("compare", a, a, "--fail-above", "0"));
    }

    [Theory]
    [InlineData("rmse", "0.9", ExitCode.CheckFailed)]
    [InlineData("rmse", "1", ExitCode.Done)]
    [InlineData("max", "0.9", ExitCode.CheckFailed)]
    [InlineData("psnr", "30", ExitCode.CheckFailed)]
    [InlineData("ssim", "0.9", ExitCode.CheckFailed)]
    [InlineData("ssim", "0", ExitCode.Done)]
    public void Compare_BlackAndWhite_FailsWhereTheLimitIsPassed(string metric, string limit, int code)
    {
        using TestFolder folder = new();
        string black = Write(folder, "a.png", Intensity.Black), white = Write(folder, "b.png", Intensity.White);
        ProgramRun run = ProgramRun.Of("compare", black, white, "--metric", metric, "--fail-above", limit);
        Assert.Equal(code, run.Code);
        Assert.StartsWith(metric + " ", run.Output, StringComparison.Ordinal);
    }

    [Fact]
    public void Compare_CommaCulture_WritesPoints()
    {
        using TestFolder folder = new();
        string a = Write(folder, "a.png", Intensity.Black), b = Write(folder, "b.png", Intensity.Grey(0.21586f));
        using CommaCulture comma = new();
        ProgramRun run = ProgramRun.Of("compare", a, b, "--metric", "max", "--fail-above", "0.75");

        // 0.21586 is the light of the sRGB code 128 (IEC 61966-2-1); 128 / 255 = 0.50196.
        Assert.StartsWith("max 0.5019", run.Output, StringComparison.Ordinal);
        Assert.Equal(ExitCode.Done, run.Code);
    }

    [Fact]
    public void Compare_Heatmap_IsWhiteWhereTheDifferenceIsLargest()
    {
        using TestFolder folder = new();
        string a = Write(folder, "a.png", Intensity.Black);
        Picture other = new(16, 16) { [3, 2] = Intensity.White };
        other.Save(folder["b.png"]);
        ProgramRun.Of("compare", a, folder["b.png"], "--heatmap", folder["heat.png"]);
        Picture heat = Picture.Load(folder["heat.png"]);
        Assert.Equal((Intensity.White, Intensity.Black), (heat[3, 2], heat[4, 2]));
    }

    [Fact]
    public void Compare_DifferentSizes_IsBadInput()
    {
        using TestFolder folder = new();
        string a = Write(folder, "a.png", Intensity.Black);
        new Picture(8, 8).Save(folder["b.png"]);
        ProgramRun run = ProgramRun.Of("compare", a, folder["b.png"]);
        Assert.Equal(ExitCode.BadInput, run.Code);
        Assert.Contains("16 x 16", run.Error, StringComparison.Ordinal);
    }

    [Fact]
    public void Compare_MissingOrBrokenPicture_IsBadInput()
    {
        using TestFolder folder = new();
        string a = Write(folder, "a.png", Intensity.Black);
        File.WriteAllText(folder["b.png"], "not a picture");
        Assert.Equal(ExitCode.BadInput, ProgramRun.Of("compare", a, folder["none.png"]).Code);
        ProgramRun run = ProgramRun.Of("compare", a, folder["b.png"]);
        Assert.Equal(ExitCode.BadInput, run.Code);
        Assert.Contains("b.png", run.Error, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("--metric", "mse", "rmse, psnr, max, ssim")]
    [InlineData("--fail-above", "-1", "at least 0")]
    [InlineData("--fail-above", "NaN", "at least 0")]
    [InlineData("--heatmap", "a.bmp", ".png")]
    public void Compare_BadOption_IsRefused(string option, string value, string allowed)
    {
        using TestFolder folder = new();
        string a = Write(folder, "a.png", Intensity.Black);
        ProgramRun run = ProgramRun.Of("compare", a, a, option, value);
        Assert.Equal(ExitCode.Usage, run.Code);
        Assert.Contains(allowed, run.Error, StringComparison.Ordinal);
    }

    private static string Write(TestFolder folder, string name, Intensity color)
    {
        Picture picture = new(16, 16);
        picture.Pixels.Fill(color);
        picture.Save(folder[name]);
        return folder[name];
    }
}
