using System.Text.RegularExpressions;

namespace LabRaytracer.PublicApi.Tests;

/// <summary>The C# in the documents is the C# in this folder, which is compiled and run.</summary>
public sealed partial class SnippetTests
{
    public static TheoryData<string> Documents => ["README.md", "docs/extending.md"];

    [Theory]
    [MemberData(nameof(Documents))]
    public void EverySnippet_IsCompiledHere(string document)
    {
        string[] regions = [.. Directory.EnumerateFiles(Path.Combine(Repository.Root, "tests", "LabRaytracer.PublicApi.Tests"), "*.cs")
            .SelectMany(file => Regions().Matches(File.ReadAllText(file).ReplaceLineEndings("\n")))
            .Select(match => Unindented(match.Groups[1].Value))];
        MatchCollection snippets = Snippets().Matches(Repository.Read(document));
        Assert.NotEmpty(snippets);
        Assert.All(snippets, snippet => Assert.Contains(snippet.Groups[1].Value.Trim('\n'), regions));
    }

    private static string Unindented(string code)
    {
        string[] lines = code.Trim('\n').Split('\n');
        int indent = lines.Where(line => line.Length > 0).Min(line => line.Length - line.TrimStart().Length);
        return string.Join('\n', lines.Select(line => line.Length > indent ? line[indent..] : line.Trim()));
    }

    [GeneratedRegex(@"```csharp\n(.*?)```", RegexOptions.Singleline)]
    private static partial Regex Snippets();

    [GeneratedRegex(@"#region snippet[^\n]*\n(.*?)\n *#endregion", RegexOptions.Singleline)]
    private static partial Regex Regions();
}
