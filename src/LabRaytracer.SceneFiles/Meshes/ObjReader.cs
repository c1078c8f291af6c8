namespace LabRaytracer;

/// <summary>What the lines of an OBJ file say, before it becomes meshes.</summary>
/// <param name="Data">The numbers.</param>
/// <param name="Materials">Lines usemtl in the order of the file: the first triangle that they are for, the name, where it stands.</param>
/// <param name="Libraries">Lines mtllib in the order of the file.</param>
internal sealed record ObjReader(ObjData Data, IReadOnlyList<(int Triangle, string Name, int Offset)> Materials, IReadOnlyList<(string Name, int Offset)> Libraries)
{
    private const int ChunkBytes = 1 << 20;

    /// <summary>Reads a file in parallel: first counts, then numbers straight into arrays of the right size.</summary>
    /// <param name="source">The file.</param>
    /// <param name="chunkBytes">Bytes that one thread reads at a time; the result does not depend on it.</param>
    /// <exception cref="SceneFileException">The file has mistakes.</exception>
    public static ObjReader Read(SceneSource source, int chunkBytes = ChunkBytes)
    {
        int[] starts = ChunkStarts(source, chunkBytes);
        int count = starts.Length - 1;
        ObjCounts[] before = new ObjCounts[count + 1];
        Parallel.For(0, count, i => before[i + 1] = ObjCounts.Of(source.Bytes, starts[i], starts[i + 1]));
        for (int i = 1; i <= count; i++)
        {
            before[i] += before[i - 1];
        }

        ObjData data = new(before[count]);
        ObjChunk[] chunks = [.. Enumerable.Range(0, count).Select(i => new ObjChunk(source, data, starts[i], starts[i + 1], before[i]))];
        Parallel.ForEach(chunks, chunk => chunk.Read());
        ThrowIfMistaken(chunks);
        if (data.Counts.Triangles == 0)
        {
            throw new SceneFileException(new SceneFileError(source.Locate(source.TextStart), "the file has no faces", "at least one line f"));
        }

        Parallel.ForEach(chunks, chunk => chunk.SplitPolygons());
        ThrowIfMistaken(chunks);
        return new ObjReader(data, [.. chunks.SelectMany(chunk => chunk.Materials)], [.. chunks.SelectMany(chunk => chunk.Libraries)]);
    }

    private static void ThrowIfMistaken(ObjChunk[] chunks)
    {
        List<SceneFileError> mistakes = [.. chunks.SelectMany(chunk => chunk.Mistakes)];
        if (mistakes.Count > 0)
        {
            throw new SceneFileException(mistakes);
        }
    }

    // A chunk starts after a line end that no backslash continues.
    private static int[] ChunkStarts(SceneSource source, int chunkBytes)
    {
        ReadOnlySpan<byte> bytes = source.Bytes;
        List<int> starts = [source.TextStart];
        while ((long)starts[^1] + chunkBytes < bytes.Length)
        {
            int middle = starts[^1] + chunkBytes - 1;
            LineText line = new(bytes, bytes[middle] == '\n' && middle > starts[^1] && bytes[middle - 1] == '\r' ? middle - 1 : middle);
            starts.Add(line.Next);
        }

        if (starts[^1] < bytes.Length || starts.Count == 1)
        {
            starts.Add(bytes.Length);
        }

        return [.. starts];
    }
}
