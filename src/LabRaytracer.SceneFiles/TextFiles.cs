using System.Runtime.ExceptionServices;
using Microsoft.Win32.SafeHandles;

namespace LabRaytracer;

/// <summary>Reads whole files, with the limits and the messages of this library.</summary>
internal static class TextFiles
{
    private const int Part = 1 << 23;

    /// <summary>The bytes of a file.</summary>
    /// <exception cref="SceneFileException">There is no such file, it is too large, or it cannot be read.</exception>
    public static byte[] Read(string path, long maxBytes, string what)
    {
        try
        {
            using FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 1);
            if (stream.Length > maxBytes)
            {
                throw Failure(path, $"the {what} file has {stream.Length} bytes", $"at most {maxBytes} bytes", null);
            }

            byte[] bytes = GC.AllocateUninitializedArray<byte>((int)stream.Length);
            ReadAll(stream, bytes);
            return bytes;
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException or NotSupportedException or ArgumentException)
        {
            string why = failure switch
            {
                FileNotFoundException or DirectoryNotFoundException => $"there is no such {what} file",
                UnauthorizedAccessException when Directory.Exists(path) => $"this is a folder, not a {what} file",
                UnauthorizedAccessException => $"the {what} file may not be read",
                _ => $"the {what} file cannot be read: {Wording.Reason(failure)}",
            };
            throw Failure(path, why, null, failure);
        }
    }

    /// <summary>Reads a file, a large one in several parts at a time.</summary>
    private static void ReadAll(FileStream stream, byte[] bytes)
    {
        if (bytes.Length <= Part)
        {
            stream.ReadExactly(bytes);
            return;
        }

        SafeFileHandle file = stream.SafeFileHandle;
        try
        {
            Parallel.For(0, ((bytes.Length - 1) / Part) + 1, part => ReadPart(file, bytes, part));
        }
        catch (AggregateException failures)
        {
            ExceptionDispatchInfo.Throw(failures.InnerExceptions[0]);
        }
    }

    private static void ReadPart(SafeFileHandle file, byte[] bytes, int part)
    {
        int end = (int)Math.Min(bytes.Length, (part + 1L) * Part);
        for (int at = part * Part; at < end;)
        {
            int read = RandomAccess.Read(file, bytes.AsSpan(at, end - at), at);
            at += read > 0 ? read : throw new EndOfStreamException("the file became shorter while it was read");
        }
    }

    private static SceneFileException Failure(string path, string what, string? allowed, Exception? inner) =>
        new(new SceneFileError(path, 1, 1, what, allowed), inner);
}
