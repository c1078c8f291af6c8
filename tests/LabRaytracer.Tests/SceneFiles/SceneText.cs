using System.Text;

namespace LabRaytracer.Tests.SceneFiles;

/// <summary>Scenes from text, and the messages of wrong ones.</summary>
internal static class SceneText
{
    /// <summary>A folder that holds nothing that a scene could name.</summary>
    public static string EmptyFolder { get; } = Path.Combine(AppContext.BaseDirectory, "no such folder");

    public static LoadedScene Read(string json, string? folder = null) => Read(Encoding.UTF8.GetBytes(json), folder);

    public static LoadedScene Read(byte[] json, string? folder = null) =>
        SceneFile.Read(new SceneSource("s.json", json), folder ?? EmptyFolder, SceneLoadOptions.Default);

    /// <summary>The message of a wrong scene.</summary>
    public static string Message(string json, string? folder = null) =>
        Assert.Throws<SceneFileException>(() => Read(json, folder)).Message;
}
