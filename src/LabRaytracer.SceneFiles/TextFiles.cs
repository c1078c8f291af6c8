namespace LabRaytracer;

/// <summary>Reads whole files, with the limits and the messages of this library.</summary>
internal static class TextFiles
{
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
            stream.ReadExactly(bytes);
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

    private static SceneFileException Failure(string path, string what, string? allowed, Exception? inner) =>
        new(new SceneFileError(path, 1, 1, what, allowed), inner);
}
