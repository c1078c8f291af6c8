using System.Runtime.InteropServices;

namespace RenderScene;

/// <summary>Ctrl-C and SIGTERM as a cancellation token.</summary>
internal sealed class SignalStop : IDisposable
{
    // What cannot be cancelled, such as reading a huge mesh, gets this long; then the process ends as it is.
    // The old picture is safe: the new one is written beside it and renamed when it is complete.
    private static readonly TimeSpan s_grace = TimeSpan.FromMilliseconds(700);

    private readonly CancellationTokenSource _source = new();
    private readonly PosixSignalRegistration _interrupt;
    private readonly PosixSignalRegistration _terminate;
    private Timer? _deadline;

    public SignalStop()
    {
        _interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, context => Stop(context, RenderScene.ExitCode.Cancelled));
        _terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, context => Stop(context, RenderScene.ExitCode.Terminated));
    }

    /// <summary>Set when a signal arrives.</summary>
    public CancellationToken Token => _source.Token;

    /// <summary>Exit code of the signal that arrived, or null.</summary>
    public int? ExitCode { get; private set; }

    public void Dispose()
    {
        _interrupt.Dispose();
        _terminate.Dispose();
        _deadline?.Dispose();
        _source.Dispose();
    }

    private void Stop(PosixSignalContext context, int exitCode)
    {
        context.Cancel = true;
        ExitCode = exitCode;
        _deadline ??= new Timer(_ => Environment.Exit(exitCode), null, s_grace, Timeout.InfiniteTimeSpan);
        _source.Cancel();
    }
}
