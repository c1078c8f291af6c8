using System.Globalization;
using Spectre.Console;

namespace RenderScene;

/// <summary>Shows how far a piece of work is.</summary>
internal static class ProgressDisplay
{
    /// <summary>Does the work and shows its progress.</summary>
    /// <param name="console">Where and how.</param>
    /// <param name="title">What is done, a few words.</param>
    /// <param name="work">The work; it reports a share in [0, 1], or gets null if nobody looks.</param>
    public static T Run<T>(AppConsole console, string title, Func<IProgress<double>?, T> work) => console.Progress switch
    {
        ProgressStyle.None => work(null),
        ProgressStyle.Lines => work(new Lines(console.Error, title)),
        _ => RunWithBar(console, title, work),
    };

    private static T RunWithBar<T>(AppConsole console, string title, Func<IProgress<double>?, T> work)
    {
        IAnsiConsole terminal = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(console.Error) });
        return terminal.Progress()
            .AutoClear(true)
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn(), new RemainingTimeColumn())
            .Start(context => work(new Bar(context.AddTask(Markup.Escape(title)))));
    }

    /// <summary>A bar of the terminal; Spectre.Console draws it from a thread of its own.</summary>
    private sealed class Bar(ProgressTask task) : IProgress<double>
    {
        public void Report(double value)
        {
            lock (task)
            {
                task.Value = Math.Max(task.Value, 100 * value);
            }
        }
    }

    /// <summary>One line for every 10 percent.</summary>
    private sealed class Lines(TextWriter writer, string title) : IProgress<double>
    {
        private readonly Lock _gate = new();
        private int _shown;

        public void Report(double value)
        {
            int tenths = (int)Math.Clamp((value * 10) + 1e-9, 0, 10);
            lock (_gate)
            {
                if (tenths > _shown)
                {
                    _shown = tenths;
                    writer.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{title}: {10 * tenths} %"));
                }
            }
        }
    }
}
