using System.Globalization;
using System.Text.Json;
using LabRaytracer;

namespace RenderScene;

/// <summary>A picture file that a render decoded: its size, and how its numbers became light.</summary>
/// <param name="File">The file, relative to the scene's folder where it lies below it.</param>
/// <param name="Width">Columns.</param>
/// <param name="Height">Rows.</param>
/// <param name="Format">What its samples are.</param>
/// <param name="Colors">How colours became light, and by which rule.</param>
internal sealed record PictureReport(string File, int Width, int Height, string Format, string Colors)
{
    /// <summary>One line for people. Data slots (heights, normals, numbers) read codes as they are unless asked otherwise.</summary>
    public string Text => string.Create(CultureInfo.InvariantCulture, $"  picture {File}: {Width} x {Height}, {Format}, colours {Colors}");

    /// <summary>The pictures of a scene that were decoded, each file once for each way to read its colours.</summary>
    public static IReadOnlyList<PictureReport> Of(LoadedScene scene) =>
    [
        .. scene.SourceMap.Pictures.Where(named => named.Picture.Decoded is not null).Select(named => Of(named.Picture, named.Picture.Decoded!, named.Location)).Distinct(),
    ];

    private static PictureReport Of(Texture picture, PixelBuffer pixels, SceneLocation place)
    {
        string folder = Path.GetDirectoryName(Path.GetFullPath(place.File)) ?? "";
        string format = pixels.Format switch { PixelFormat.Rgba8 => "8 bits", PixelFormat.Rgba16 => "16 bits", _ => "float" };
        return new PictureReport(
            Path.GetRelativePath(folder, picture.Path).Replace('\\', '/'), pixels.Width, pixels.Height, pixels.HasAlpha ? $"{format} with alpha" : format, picture.ColorRule);
    }

    /// <summary>The same for programs.</summary>
    public void WriteJson(Utf8JsonWriter json)
    {
        json.WriteStartObject();
        json.WriteString("file", File);
        json.WriteNumber("width", Width);
        json.WriteNumber("height", Height);
        json.WriteString("format", Format);
        json.WriteString("colors", Colors);
        json.WriteEndObject();
    }
}
