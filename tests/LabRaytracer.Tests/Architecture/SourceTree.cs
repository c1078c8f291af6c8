using System.Runtime.CompilerServices;
using System.Text.RegularExpressions;

namespace LabRaytracer.Tests.Architecture;

/// <summary>The source files of this repository.</summary>
internal static partial class SourceTree
{
    /// <summary>The repository's folder: the one that holds LabRaytracer.sln.</summary>
    public static string Root { get; } = FindRoot();

    /// <summary>Source files under a folder, paths relative to the repository with slashes.</summary>
    public static IEnumerable<string> Files(string folder) => Directory.EnumerateFiles(Path.Combine(Root, folder), "*.cs", SearchOption.AllDirectories)
        .Select(path => Path.GetRelativePath(Root, path).Replace('\\', '/'))
        .Where(path => !path.Contains("/obj/", StringComparison.Ordinal) && !path.Contains("/bin/", StringComparison.Ordinal))
        .Order(StringComparer.Ordinal);

    /// <summary>The text of a file.</summary>
    public static string Read(string file) => File.ReadAllText(Path.Combine(Root, file));

    /// <summary>The text of a file without comments and without the contents of strings.</summary>
    public static string Code(string file) => Words().Replace(Comments().Replace(Read(file), ""), "\"\"");

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

    [GeneratedRegex(@"//[^\n]*|/\*.*?\*/", RegexOptions.Singleline)]
    private static partial Regex Comments();

    [GeneratedRegex("""
        "(\\.|[^"\\\n])*"
        """, RegexOptions.IgnorePatternWhitespace)]
    private static partial Regex Words();
}
