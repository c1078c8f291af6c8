using RenderScene;
using Spectre.Console;

namespace LabRaytracer.Tests.Samples;

public sealed class PreviewTests
{
    [Fact]
    public void Render_PreviewInAPipe_SaysWhyAndWritesNoEscapes()
    {
        using TestFolder folder = new();
        ProgramRun run = ProgramRun.Of("render", ProgramRun.WriteScene(folder), "-o", folder["a.png"], "--preview");
        Assert.Equal(ExitCode.Done, run.Code);
        Assert.EndsWith("no preview: the output goes into a pipe or a file, not to a terminal.\n", run.Error, StringComparison.Ordinal);
        Assert.DoesNotContain('\u001b', run.Output + run.Error);
    }

    [Fact]
    public void Render_PreviewOnATerminal_DrawsThePicture()
    {
        using TestFolder folder = new();
        using StringWriter output = new() { NewLine = "\n" }, error = new();
        AppConsole console = new(output, error, ProgressStyle.None) { Screen = () => PreviewScreen.On(Terminal(output, 16, 24)) };
        Assert.Equal(ExitCode.Done, App.Run(["render", ProgramRun.WriteScene(folder), "-o", folder["a.png"], "--preview"], console, CancellationToken.None));

        // 32 x 18 pixels on 16 columns: 16 x 9, two rows a character.
        string[] lines = output.ToString().TrimEnd('\n').Split('\n');
        Assert.Equal((5 + 1, 16), (lines.Length, lines[0].Count(c => c == '\u2580')));
        Assert.Equal("", error.ToString());
    }

    [Fact]
    public void Draw_FourPixels_ShowsTheirDisplayColours()
    {
        Picture picture = new(2, 2);
        picture[0, 0] = new Intensity(1, 0, 0);
        picture[1, 0] = new Intensity(0, 7, 0);
        picture[0, 1] = new Intensity(0, 0, 1);
        picture[1, 1] = Intensity.Grey(0.5f);
        using StringWriter output = new() { NewLine = "\n" };
        TerminalPreview.Draw(picture, Terminal(output, 80, 24));

        // Light 0.5 is the sRGB code 188 (IEC 61966-2-1).
        Assert.Equal("\u001b[38;2;255;0;0;48;2;0;0;255m\u2580\u001b[0m\u001b[38;2;0;255;0;48;2;188;188;188m\u2580\u001b[0m\n", output.ToString());
    }

    [Theory]
    [InlineData(true, null, "xterm", false, "pipe")]
    [InlineData(false, "1", "xterm", false, "NO_COLOR")]
    [InlineData(false, "", "dumb", false, "TERM=dumb")]
    [InlineData(false, null, null, false, "TERM is not set")]
    [InlineData(false, null, null, true, null)]
    [InlineData(false, "", "xterm-256color", false, null)]
    public void FindRefusal_Surroundings_AreRespected(bool isRedirected, string? noColor, string? term, bool isWindows, string? word)
    {
        string? refusal = PreviewScreen.FindRefusal(isRedirected, noColor, term, isWindows);
        Assert.Equal(word is null, refusal is null);
        Assert.Contains(word ?? "", refusal ?? "", StringComparison.Ordinal);
    }

    private static IAnsiConsole Terminal(TextWriter writer, int width, int height)
    {
        IAnsiConsole terminal = AnsiConsole.Create(new AnsiConsoleSettings
        {
            Ansi = AnsiSupport.Yes, ColorSystem = ColorSystemSupport.TrueColor, Interactive = InteractionSupport.No, Out = new AnsiConsoleOutput(writer),
        });
        terminal.Profile.Width = width;
        terminal.Profile.Height = height;
        return terminal;
    }
}
