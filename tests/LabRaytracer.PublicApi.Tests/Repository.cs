using System.Runtime.CompilerServices;

namespace LabRaytracer.PublicApi.Tests;

/// <summary>Files of the repository.</summary>
internal static class Repository
{
    /// <summary>The folder that holds LabRaytracer.sln.</summary>
    public static string Root { get; } = FindRoot();

    /// <summary>Text of a file.</summary>
    public static string Read(string path) => File.ReadAllText(Path.Combine(Root, path)).ReplaceLineEndings("\n");

    private static string FindRoot([CallerFilePath] string here = "")
    {
        foreach (string start in new[] { Path.GetDirectoryName(here)!, AppContext.BaseDirectory })
        {
            for (DirectoryInfo? folder = new(start); folder is not null; folder = folder.Parent)
            {
                if (File.Exists(Path.Combine(folder.FullName, "LabRaytracer.sln")))
                {
                    return folder.FullName;
                }
            }
        }

        throw new DirectoryNotFoundException("LabRaytracer.sln was not found above the test's folder.");
    }
}
