namespace LabRaytracer.PublicApi.Tests;

/// <summary>The public API and the scene format are what the reviewed texts say, until somebody decides otherwise.</summary>
public sealed class ApiBaselineTests
{
    private const string Update = "LABRAYTRACER_UPDATE_PUBLIC_API";

    [Fact]
    public void PublicApi_IsTheReviewedOne() => Check(
        "tests/LabRaytracer.PublicApi.Tests/PublicApi.txt", ApiText.Of(typeof(Texture).Assembly, typeof(SceneFile).Assembly));

    [Fact]
    public void SceneFormat_IsWhatTheSchemaSays() => Check("docs/scene-format.md", SceneFormatText.Create());

    private static void Check(string file, string actual)
    {
        string path = Path.Combine(Repository.Root, file);
        if (Environment.GetEnvironmentVariable(Update) == "1")
        {
            File.WriteAllText(path, actual);
        }

        string[] reviewed = Repository.Read(file).Split('\n'), found = actual.Split('\n');
        string changes = string.Join('\n', found.Except(reviewed).Select(line => "+ " + line).Concat(reviewed.Except(found).Select(line => "- " + line)));
        Assert.True(
            reviewed.SequenceEqual(found),
            $"{file} differs from what is public:\n{changes}\nIf that is meant, note it in CHANGELOG.md and run: {Update}=1 dotnet test tests/LabRaytracer.PublicApi.Tests");
    }
}
