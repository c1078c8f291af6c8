using LabRaytracer;

namespace RenderScene;

/// <summary>The generated files that the scenes of scenes/bench need.</summary>
internal sealed class BenchData
{
    private const int Pictures = 8;

    private readonly string _folder;
    private readonly int _reduce;

    /// <summary>Prepares to write into a folder.</summary>
    /// <param name="folder">The folder.</param>
    /// <param name="reduce">Sides of pictures and of the mesh are divided by this; 1 for the real ones.</param>
    public BenchData(string folder, int reduce)
    {
        _folder = folder;
        _reduce = reduce;
    }

    private static IEnumerable<string> Files =>
        [.. Enumerable.Range(0, Pictures).Select(number => $"tex{number}.png"), "checker.png", "checker_fine.png", "torus.obj"];

    /// <summary>Names the command that makes the files, if this is a bench scene and they are missing.</summary>
    /// <exception cref="InputException">Files are missing.</exception>
    public static void ThrowIfMissing(string scenePath)
    {
        string folder = Path.GetDirectoryName(Path.GetFullPath(scenePath)) ?? "";
        string data = Path.Combine(folder, "data");
        bool isUser = Path.GetFileName(folder) == "bench" && File.Exists(scenePath) && File.ReadAllText(scenePath).Contains("\"data/", StringComparison.Ordinal);
        if (isUser && Files.FirstOrDefault(name => !File.Exists(Path.Combine(data, name))) is { } missing)
        {
            string relative = Path.GetRelativePath(Directory.GetCurrentDirectory(), data);
            throw new InputException($"{scenePath} needs generated files, and '{Path.Combine(relative, missing)}' is missing; make them first with: bench-data {relative}");
        }
    }

    /// <summary>Writes all files, several at a time.</summary>
    /// <param name="progress">Told the share that is done.</param>
    /// <param name="stop">Stops between two files.</param>
    public void Write(IProgress<double>? progress, CancellationToken stop)
    {
        PictureOutput.MakeFolder(_folder);
        List<Action> tasks = [.. Enumerable.Range(0, Pictures).Select<int, Action>(number => () => Save(BenchPictures.Busy(2048 / _reduce, 1024 / _reduce, number), $"tex{number}.png"))];
        tasks.Insert(0, () => AtomicFile.Write(InFolder("torus.obj"), new BenchTorus(1000 / _reduce, 500 / _reduce).Write));
        tasks.Add(() => Save(BenchPictures.Checker(1024 / _reduce, 8), "checker.png"));
        tasks.Add(() => Save(BenchPictures.Checker(1024 / _reduce, 64), "checker_fine.png"));
        int done = 0;
        Parallel.ForEach(tasks, new ParallelOptions { CancellationToken = stop }, task =>
        {
            task();
            progress?.Report((double)Interlocked.Increment(ref done) / tasks.Count);
        });
    }

    private void Save(Picture picture, string name) => picture.Save(InFolder(name), new PictureSaveOptions { Encoding = TransferFunction.Linear });

    private string InFolder(string name) => Path.Combine(_folder, name);
}
