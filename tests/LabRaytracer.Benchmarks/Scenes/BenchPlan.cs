using System.Globalization;

namespace LabRaytracer.Benchmarks;

/// <summary>How much is measured, and where the report goes.</summary>
internal sealed record BenchPlan
{
    /// <summary>The words of the command line.</summary>
    public required string Command { get; init; }

    /// <summary>Folder of the report.</summary>
    public required string Folder { get; init; }

    /// <summary>Rounds; medians are reported.</summary>
    public int Rounds { get; init; } = 5;

    /// <summary>Width of the pictures, pixels.</summary>
    public int Width { get; init; } = 1920;

    /// <summary>Height of the pictures, pixels.</summary>
    public int Height { get; init; } = 1080;

    /// <summary>Sides of pictures and of the mesh are divided by this.</summary>
    public int Reduce { get; init; } = 1;

    /// <summary>Samples a pixel of the converged picture.</summary>
    public int ReferenceSamples { get; init; } = 1024;

    /// <summary>Largest number of spheres of the sweep.</summary>
    public int MostSpheres { get; init; } = 100_000;

    /// <summary>Largest number of triangles of the sweep.</summary>
    public int MostTriangles { get; init; } = 1_000_000;

    /// <summary>Folder of the repository.</summary>
    public static string Root { get; } = FindRoot();

    /// <summary>Reads the command line.</summary>
    public static bool TryParse(string[] words, out BenchPlan? plan, out string message)
    {
        string here = Path.Combine(Root, "tests", "LabRaytracer.Benchmarks");
        plan = new BenchPlan { Command = string.Join(' ', words.Prepend("scenes")), Folder = here };
        message = "";
        for (int i = 0; i < words.Length && plan is not null; i++)
        {
            plan = words[i] switch
            {
                "--short" => plan with
                {
                    Folder = Path.Combine(Root, "artifacts", "bench"),
                    Rounds = 3,
                    Width = 384,
                    Height = 216,
                    Reduce = 8,
                    ReferenceSamples = 256,
                    MostSpheres = 10_000,
                    MostTriangles = 100_000,
                },
                "--long" => plan with { Rounds = 9, MostSpheres = 1_000_000, MostTriangles = 4_000_000 },
                "--rounds" when i + 1 < words.Length && int.TryParse(words[i + 1], NumberStyles.None, CultureInfo.InvariantCulture, out int rounds) && rounds > 0
                    => Next(plan with { Rounds = rounds }, ref i),
                "--out" when i + 1 < words.Length => Next(plan with { Folder = Path.GetFullPath(words[i + 1]) }, ref i),
                _ => null,
            };
            message = plan is null ? $"'{words[i]}' is not understood here. Allowed: scenes [--short | --long] [--rounds N] [--out FOLDER]." : "";
        }

        return plan is not null;
    }

    private static BenchPlan Next(BenchPlan plan, ref int word)
    {
        word++;
        return plan;
    }

    private static string FindRoot()
    {
        DirectoryInfo? folder = new(AppContext.BaseDirectory);
        while (folder is not null && !File.Exists(Path.Combine(folder.FullName, "LabRaytracer.sln")))
        {
            folder = folder.Parent;
        }

        return folder?.FullName ?? throw new DirectoryNotFoundException("LabRaytracer.sln is in no folder above the program; run it from the repository.");
    }
}
