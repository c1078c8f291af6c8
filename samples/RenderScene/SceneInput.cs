using LabRaytracer;

namespace RenderScene;

/// <summary>Scene files on their way to a picture, with failures that name the place in the file.</summary>
internal static class SceneInput
{
    private const long LargeScene = 1 << 26;

    /// <summary>Reads a scene file.</summary>
    /// <param name="path">The file.</param>
    /// <param name="options">What it may name; null for the defaults.</param>
    /// <exception cref="InputException">It needs generated files that are not there yet.</exception>
    /// <exception cref="SceneFileException">It cannot be read.</exception>
    public static LoadedScene Load(string path, SceneLoadOptions? options = null)
    {
        BenchData.ThrowIfMissing(path);
        LoadedScene scene = SceneFile.Load(path, options);
        if (GC.GetTotalMemory(forceFullCollection: false) > LargeScene)
        {
            // The text of a large mesh is of no use any more, and the trees that are built next would come on top of it.
            GC.Collect(GC.MaxGeneration, GCCollectionMode.Aggressive, blocking: true, compacting: true);
        }

        return scene;
    }

    /// <summary>Renders a scene into a picture file and shows the progress; stopped, it leaves the old file as it was.</summary>
    /// <remarks>A PNG file is compressed while the picture is rendered, and the picture never held as a whole.</remarks>
    /// <exception cref="SceneFileException">A picture of the scene cannot be decoded.</exception>
    public static RenderStatistics Render(
        LoadedScene scene, string title, RenderOptions options, string path, PictureSaveOptions save, AppConsole console, CancellationToken stop)
    {
        if (PictureCodecs.Default.FindWriter(path) is not PngCodec)
        {
            RenderResult result = Run(scene, console, title, progress => Renderer.Render(scene.Scene, options, progress, stop));
            PictureOutput.Save(result.Picture, path, save, stop);
            return result.Statistics;
        }

        RenderStatistics? statistics = null;
        AtomicFile.Write(path, file =>
        {
            using StoppableStream stream = new(file, stop);
            PixelRectangle area = Renderer.Area(options);
            PngRowWriter writer = new(stream, area.Width, area.Height, save);
            statistics = Run(scene, console, title, progress => Renderer.Render(scene.Scene, options, writer, progress, stop));
            writer.Finish();
        });
        return statistics!;
    }

    private static T Run<T>(LoadedScene scene, AppConsole console, string title, Func<IProgress<double>?, T> render)
    {
        try
        {
            return ProgressDisplay.Run(console, title, render);
        }
        catch (Exception failure) when (Cause(failure) is { } cause && FindTexture(scene.Scene, cause) is { } texture)
        {
            throw scene.SourceMap.Explain(texture, cause);
        }
    }

    /// <summary>The failure of a picture file among those that made the render fail, or null.</summary>
    private static Exception? Cause(Exception? failure) => failure switch
    {
        null => null,
        PictureFormatException or FileNotFoundException => failure,
        AggregateException several => several.InnerExceptions.Select(Cause).FirstOrDefault(cause => cause is not null),
        _ => Cause(failure.InnerException),
    };

    private static Texture? FindTexture(Scene scene, Exception cause)
    {
        string? path = cause is PictureFormatException format ? format.Path : ((FileNotFoundException)cause).FileName;
        return SceneTextures.Used(scene).Select(use => use.Texture).OfType<Texture>().FirstOrDefault(texture => texture.Path == path);
    }
}
