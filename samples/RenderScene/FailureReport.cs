using LabRaytracer;

namespace RenderScene;

/// <summary>Failures in words.</summary>
internal static class FailureReport
{
    /// <summary>Says in one or a few lines what went wrong; never with a stack trace.</summary>
    /// <param name="failure">What went wrong.</param>
    /// <param name="error">Where it is said.</param>
    /// <returns>The <see cref="ExitCode"/> of the failure.</returns>
    public static int Write(Exception failure, TextWriter error)
    {
        while (failure is AggregateException { InnerExceptions.Count: > 0 } several)
        {
            failure = several.InnerExceptions[0];
        }

        (int code, string message) = failure switch
        {
            OperationCanceledException => (ExitCode.Cancelled, "cancelled; files that were there before are as they were"),
            UsageException => (ExitCode.Usage, failure.Message),
            FileNotFoundException missing => (ExitCode.BadInput, $"there is no file '{missing.FileName}'; check its name and the folder you are in."),
            SceneFileException or PictureFormatException or InputException or IOException or UnauthorizedAccessException => (ExitCode.BadInput, failure.Message),
            OutOfMemoryException => (ExitCode.BadInput, "there is not enough memory; make the picture or the scene smaller"),
            _ => (ExitCode.BadInput, $"unexpected failure: {failure.Message}"),
        };
        error.WriteLine(code == ExitCode.Cancelled ? message : $"error: {message}");
        return code;
    }
}
