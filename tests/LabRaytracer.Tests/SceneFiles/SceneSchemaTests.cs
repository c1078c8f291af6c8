namespace LabRaytracer.Tests.SceneFiles;

public sealed class SceneSchemaTests
{
    [Fact]
    public void Generate_SchemaInScenesFolder_IsTheSameText()
    {
        string kept = File.ReadAllText(Path.Combine(RepositoryFolder(), "scenes", "scene.schema.json"));
        Assert.True(kept == SceneSchema.Generate(), "scenes/scene.schema.json is out of date: write it again with the sample's verb 'schema'.");
    }

    [Fact]
    public void Generate_Twice_IsTheSameText() => Assert.Equal(SceneSchema.Generate(), SceneSchema.Generate());

    private static string RepositoryFolder()
    {
        DirectoryInfo? folder = new(AppContext.BaseDirectory);
        while (folder is not null && !File.Exists(Path.Combine(folder.FullName, "LabRaytracer.sln")))
        {
            folder = folder.Parent;
        }

        return folder?.FullName ?? throw new InvalidOperationException("The tests must run inside the repository's folder.");
    }
}
