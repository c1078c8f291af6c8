using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using LabRaytracer;

namespace RenderScene;

/// <summary>bake SCENE TEXTURE: a texture of a scene becomes a picture file, and how far the picture is from it.</summary>
internal static class BakeVerb
{
    // Two by two places in every texel say enough about the error, in a quarter of the time of the library's default.
    private const int ErrorGrid = 2;

    private const int MaxTexels = 1 << 26;

    private static readonly Dictionary<string, Func<TextureCoordinate, SurfacePosition>?> s_surfaces = new()
    {
        ["plane"] = null, ["rectangle"] = BakeSurfaces.Rectangle, ["cylinder"] = BakeSurfaces.Cylinder, ["sphere"] = BakeSurfaces.Sphere,
    };

    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console, CancellationToken stop)
    {
        Argument<string> scene = new("scene") { Description = "The scene file." };
        Argument<string> texture = new("texture") { Description = "Name of one of its textures." };
        Option<string?> output = new("--output", "-o") { HelpName = "FILE", Description = "The picture: .png, .ppm, .pfm or .hdr. Default: out/NAME-OF-TEXTURE.png." };
        Option<string?> size = new("--size") { HelpName = "WxH", Description = "Size of the picture, texels. Default: 1024x512." };
        Option<string?> surface = new("--surface")
        {
            HelpName = string.Join('|', s_surfaces.Keys), Description = "What (u, v) are spread over, for textures that fill space: the plane (u, v, 0), or the unit form of a shape. Default: plane.",
        };
        Command command = new("bake", "Makes a picture of a texture, such as marble, and says how far the picture's bilinear lookup is from it.") { scene, texture, output, size, surface };
        command.SetAction(parsed =>
        {
            int[] sides = OptionText.Integers("--size", parsed.GetValue(size) ?? "1024x512", 'x', "WxH");
            if (sides.Any(side => side < 1) || (long)sides[0] * sides[1] > MaxTexels)
            {
                throw new UsageException(string.Create(CultureInfo.InvariantCulture, $"--size {sides[0]}x{sides[1]} is not possible: at least 1 texel a side and at most {MaxTexels} in all."));
            }

            Func<TextureCoordinate, SurfacePosition>? spread = parsed.GetValue(surface) is { } word ? OptionText.Word("--surface", word, s_surfaces!) : null;
            string path = parsed.GetRequiredValue(scene), name = parsed.GetRequiredValue(texture);
            ITexture source = Find(SceneInput.Load(path), path, name);
            string target = parsed.GetValue(output) ?? PictureOutput.DefaultPath($"{FileName(name)}.png");
            PictureOutput.Check(target);
            Run(source, name, sides, spread, target, console, stop);
            return ExitCode.Done;
        });
        return command;
    }

    private static void Run(
        ITexture source, string name, int[] size, Func<TextureCoordinate, SurfacePosition>? surface, string target, AppConsole console, CancellationToken stop)
    {
        Stopwatch clock = Stopwatch.StartNew();
        BakedTexture baked = BakedTexture.Bake(source, size[0], size[1], new BakeOptions { Surface = surface, ErrorGrid = ErrorGrid });
        Picture picture = new(size[0], size[1]);
        for (int y = 0; y < size[1]; y++)
        {
            for (int x = 0; x < size[0]; x++)
            {
                // v points up, rows of pictures go down.
                picture[x, size[1] - 1 - y] = baked.Texture.ColorMap[x, y];
            }
        }

        PictureOutput.Save(picture, target, PictureOutput.WithText(PictureSaveOptions.Default, new("Title", name), new("Software", $"LabRaytracer {VersionVerb.Version}")), stop);
        console.Output.WriteLine(string.Create(
            CultureInfo.InvariantCulture,
            $"{target}: {size[0]} x {size[1]} texels; their bilinear lookup differs by {baked.RootMeanSquareError:0.000000} root mean square, {baked.LargestError:0.000000} at most, linear light; {clock.Elapsed.TotalSeconds:0.00} s"));
    }

    private static ITexture Find(LoadedScene scene, string path, string name) => scene.Textures.TryGetValue(name, out ITexture? texture)
        ? texture
        : throw new UsageException(scene.Textures.Count == 0
            ? $"'{path}' names no textures."
            : $"'{path}' has no texture '{Wording.Name(name)}'{Wording.Suggestion(name, scene.Textures.Keys)}; allowed: {Wording.List(scene.Textures.Keys)}.");

    private static string FileName(string name) => string.Concat(name.Select(c => char.IsLetterOrDigit(c) || c is '-' or '_' ? c : '-'));
}
