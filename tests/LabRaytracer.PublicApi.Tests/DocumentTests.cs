using System.Text.RegularExpressions;

namespace LabRaytracer.PublicApi.Tests;

/// <summary>What the documents name is there.</summary>
public sealed partial class DocumentTests
{
    public static TheoryData<string> Documents => ["README.md", "docs/errata.md", "docs/extending.md", "docs/filtering.md", "docs/scene-format.md", "samples/Exercises/README.md", "CHANGELOG.md"];

    [Theory]
    [MemberData(nameof(Documents))]
    public void EveryLink_LeadsToAFile(string document)
    {
        string folder = Path.GetDirectoryName(Path.Combine(Repository.Root, document))!;
        Assert.All(
            Links().Matches(Repository.Read(document)).Select(match => match.Groups[1].Value),
            link => Assert.True(File.Exists(Path.Combine(folder, link)), $"{document} links to {link}, which is not there."));
    }

    [Theory]
    [MemberData(nameof(Documents))]
    public void EveryTestAndFile_ThatIsNamed_Exists(string document)
    {
        string tests = string.Concat(Directory.EnumerateFiles(Path.Combine(Repository.Root, "tests"), "*Tests.cs", SearchOption.AllDirectories).Select(File.ReadAllText));
        string text = Repository.Read(document);
        Assert.All(TestNames().Matches(text).Select(match => match.Groups[1].Value), name => Assert.Contains($" {name}(", tests, StringComparison.Ordinal));
        Assert.All(
            Paths().Matches(text).Select(match => match.Groups[1].Value),
            path => Assert.True(Path.Exists(Path.Combine(Repository.Root, path)), $"{document} names {path}, which is not there."));
    }

    [GeneratedRegex(@"\]\(([^)#:]+)\)")]
    private static partial Regex Links();

    [GeneratedRegex(@"`([A-Z]\w*_[A-Z]\w*)`")]
    private static partial Regex TestNames();

    [GeneratedRegex(@"`((?:src|tests|samples|scenes|docs)/[\w./-]*)`")]
    private static partial Regex Paths();
}
