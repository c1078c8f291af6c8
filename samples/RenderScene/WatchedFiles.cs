namespace RenderScene;

/// <summary>Files whose changes are waited for.</summary>
/// <remarks>
/// They are looked at again and again instead of asking the system for messages: that also notices editors that write a new file and rename it, files that
/// come and go, and folders of a network, which send none. Not thread safe.
/// </remarks>
internal sealed class WatchedFiles
{
    private static readonly TimeSpan s_between = TimeSpan.FromMilliseconds(100);

    // Editors and exporters write in steps; a file that stayed the same for so long is taken for finished.
    private static readonly TimeSpan s_rest = TimeSpan.FromMilliseconds(200);

    private readonly Dictionary<string, Stamp> _seen = new(StringComparer.Ordinal);

    /// <summary>Number of files.</summary>
    public int Count => _seen.Count;

    /// <summary>Forgets all files.</summary>
    public void Clear() => _seen.Clear();

    /// <summary>Watches a file from its present state on; of one that is watched already the first state counts.</summary>
    /// <param name="path">The file; it need not be there yet.</param>
    public void Add(string path)
    {
        string full = Path.GetFullPath(path);
        _seen.TryAdd(full, Stamp.Of(full));
    }

    /// <summary>No longer watches a file.</summary>
    public void Remove(string path) => _seen.Remove(Path.GetFullPath(path));

    /// <summary>Waits until a file is not what it was when it was added, and then until all of them rest.</summary>
    /// <param name="stop">Ends the waiting.</param>
    /// <returns>False if it was stopped.</returns>
    public bool WaitForChange(CancellationToken stop)
    {
        string[] paths = [.. _seen.Keys];
        Stamp[] known = [.. _seen.Values];
        Stamp[] now = Look(paths);
        while (now.SequenceEqual(known))
        {
            if (stop.WaitHandle.WaitOne(s_between))
            {
                return false;
            }

            now = Look(paths);
        }

        Stamp[] before;
        do
        {
            if (stop.WaitHandle.WaitOne(s_rest))
            {
                return false;
            }

            before = now;
            now = Look(paths);
        }
        while (!now.SequenceEqual(before));
        return true;
    }

    private static Stamp[] Look(string[] paths) => [.. paths.Select(Stamp.Of)];

    /// <summary>What tells two states of a file apart.</summary>
    /// <param name="Written">When it was written.</param>
    /// <param name="Length">Its length, bytes; -1 of none.</param>
    private readonly record struct Stamp(DateTime Written, long Length)
    {
        public static Stamp Of(string path)
        {
            try
            {
                FileInfo file = new(path);
                return file.Exists ? new Stamp(file.LastWriteTimeUtc, file.Length) : new Stamp(default, -1);
            }
            catch (Exception failure) when (failure is IOException or UnauthorizedAccessException)
            {
                return new Stamp(default, -1);
            }
        }
    }
}
