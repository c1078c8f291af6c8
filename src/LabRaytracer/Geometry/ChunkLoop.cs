namespace LabRaytracer;

/// <summary>A loop over many numbers, in chunks, on several threads.</summary>
internal static class ChunkLoop
{
    /// <summary>Does the numbers [0, count).</summary>
    /// <param name="count">How many.</param>
    /// <param name="chunk">How many at a time.</param>
    /// <param name="threads">Threads that may work on it, at least 1; one chunk is done at once.</param>
    /// <param name="body">Does the numbers [first, end).</param>
    public static void Run(int count, int chunk, int threads, Action<int, int> body)
    {
        if (threads == 1 || count <= chunk)
        {
            body(0, count);
            return;
        }

        Parallel.For(0, ((count - 1) / chunk) + 1, new ParallelOptions { MaxDegreeOfParallelism = threads }, i => body(i * chunk, Math.Min(count, (i * chunk) + chunk)));
    }
}
