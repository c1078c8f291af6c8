using LabRaytracer;
using LabRaytracer.Validation;

namespace RenderScene;

/// <summary>The bench scenes and the stress scenes as whole renders in float, double and exact mode.</summary>
internal static class StressRenders
{
    /// <summary>Sides of the bench scenes' pictures and mesh are divided by this: small pictures do not see more.</summary>
    private const int Reduce = 4;

    private static readonly string[] s_bench = ["s1", "s2", "s3", "s4", "s5"];

    /// <summary>Measures all scenes; lines are told as soon as they are known.</summary>
    /// <returns>The table in Markdown.</returns>
    public static string Measure(TextWriter output, CancellationToken stop)
    {
        string folder = Directory.CreateTempSubdirectory("LabRaytracer").FullName;
        try
        {
            string table = RenderComparison.Head;
            output.Write(table);
            foreach (string path in (string[])[.. Bench(folder, stop), .. Stress()])
            {
                LoadedScene scene = SceneInput.Load(path);
                RenderOptions options = new() { Width = 480, Height = 270, MaxDepth = scene.RenderOptions.MaxDepth };
                string name = $"{Path.GetFileName(Path.GetDirectoryName(path))}/{Path.GetFileNameWithoutExtension(path)}";
                string line = RenderComparison.Measure(name, scene.Scene, options).ToMarkdown();
                output.Write(line);
                table += line;
                stop.ThrowIfCancellationRequested();
            }

            return table;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    /// <summary>The bench scenes, copied beside small data of their own.</summary>
    private static IEnumerable<string> Bench(string folder, CancellationToken stop)
    {
        string bench = Path.Combine(folder, "bench");
        new BenchData(Path.Combine(bench, "data"), Reduce).Write(null, stop);
        foreach (string name in s_bench)
        {
            string path = Path.Combine(bench, name + ".json");
            File.Copy(SampleScenes.File(Path.Combine("bench", name + ".json")), path);
            yield return path;
        }
    }

    private static IEnumerable<string> Stress() => Directory.GetFiles(Path.Combine(SampleScenes.Find(), "stress"), "*.json").Order(StringComparer.Ordinal);
}
