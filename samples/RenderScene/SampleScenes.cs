namespace RenderScene;

/// <summary>The folder with the scenes that come with the program.</summary>
internal static class SampleScenes
{
    /// <summary>The folder: "scenes" in the current folder, or beside the sources that the program was built from.</summary>
    /// <exception cref="InputException">There is none.</exception>
    public static string Find()
    {
        IEnumerable<string> places = Above(AppContext.BaseDirectory).Prepend(Directory.GetCurrentDirectory());
        return places.Select(place => Path.Combine(place, "scenes")).FirstOrDefault(folder => System.IO.File.Exists(Path.Combine(folder, "01-constant.json")))
            ?? throw new InputException("the folder 'scenes' with 01-constant.json is not here; run the program from the folder of LabRaytracer.sln.");
    }

    /// <summary>A file of the folder, as short as it can be said from here.</summary>
    public static string File(string name)
    {
        string path = Path.Combine(Find(), name), relative = Path.GetRelativePath(Directory.GetCurrentDirectory(), path);
        return relative.Length < path.Length ? relative : path;
    }

    private static IEnumerable<string> Above(string folder)
    {
        for (DirectoryInfo? at = new(folder); at is not null; at = at.Parent)
        {
            yield return at.FullName;
        }
    }
}
