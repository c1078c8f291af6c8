namespace LabRaytracer;

/// <summary>Files that are complete or not there: written beside the target, flushed to the disk, then renamed over it.</summary>
internal static class AtomicFile
{
    /// <summary>Replaces a file by what <paramref name="write"/> produces; on any failure the old file stays as it was.</summary>
    /// <exception cref="IOException">The target cannot be written.</exception>
    public static void Write(string path, Action<Stream> write)
    {
        string target = Resolve(path);
        if (IsDevice(target))
        {
            using FileStream device = Open(path, target, FileMode.Open);
            write(device);
            device.Flush();
            return;
        }

        string temporary = TemporaryName(target);
        try
        {
            using (FileStream stream = Open(path, temporary, FileMode.CreateNew))
            {
                write(stream);
                stream.Flush(flushToDisk: true);
            }

            File.Move(temporary, target, overwrite: true);
        }
        catch (Exception failure)
        {
            Remove(temporary);
            if (failure is UnauthorizedAccessException)
            {
                throw Unwritable(path, failure);
            }

            throw;
        }
    }

    /// <summary>Throws if <see cref="Write"/> would fail at once; changes nothing.</summary>
    /// <exception cref="IOException">The target cannot be written.</exception>
    public static void Check(string path)
    {
        string target = Resolve(path);
        if (IsDevice(target))
        {
            Open(path, target, FileMode.Open).Dispose();
            return;
        }

        string temporary = TemporaryName(target);
        Open(path, temporary, FileMode.CreateNew).Dispose();
        Remove(temporary);
    }

    /// <summary>The file to replace: a symbolic link stays a link, what it points to is replaced.</summary>
    private static string Resolve(string path)
    {
        string full = Path.GetFullPath(path);
        if (Directory.Exists(full))
        {
            throw new IOException($"Cannot write '{path}': this is a folder; name a file in it.");
        }

        string? folder = Path.GetDirectoryName(full);
        if (folder is not null && !Directory.Exists(folder))
        {
            throw new IOException($"Cannot write '{path}': there is no folder '{folder}'; create it first.");
        }

        try
        {
            FileInfo file = new(full);
            return file.LinkTarget is null ? full : file.ResolveLinkTarget(returnFinalTarget: true)?.FullName ?? full;
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            throw Unwritable(path, failure);
        }
    }

    /// <summary>Devices such as /dev/stdout or /dev/full are written to; renaming over them would destroy them.</summary>
    private static bool IsDevice(string target) =>
        !OperatingSystem.IsWindows()
        && (target.StartsWith("/dev/", StringComparison.Ordinal) || target.StartsWith("/proc/", StringComparison.Ordinal))
        && !target.StartsWith("/dev/shm/", StringComparison.Ordinal);

    private static string TemporaryName(string target) =>
        Path.Combine(Path.GetDirectoryName(target) ?? string.Empty, $".{Guid.NewGuid():N}.part");

    private static FileStream Open(string path, string actual, FileMode mode)
    {
        try
        {
            return new FileStream(actual, mode, FileAccess.Write, FileShare.None, 1 << 16);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            throw Unwritable(path, failure);
        }
    }

    private static IOException Unwritable(string path, Exception failure) =>
        new($"Cannot write '{path}': {failure.Message.TrimEnd('.')}. Choose another place or change its permissions.", failure);

    private static void Remove(string temporary)
    {
        try
        {
            File.Delete(temporary);
        }
        catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
        {
            // The first failure is the one to report; a left-over part file harms nobody.
        }
    }
}
