using System.CommandLine;
using LabRaytracer;

namespace RenderScene;

/// <summary>draw-textures FOLDER: draws the small pictures of scenes/textures again.</summary>
internal static class DrawTexturesVerb
{
    /// <summary>The verb for the command line.</summary>
    public static Command Create(AppConsole console)
    {
        Argument<string> folder = new("folder") { Description = "Where the files go: scenes/textures for those of the scenes." };
        Command command = new("draw-textures", "Draws the small pictures of scenes/textures again; the same bytes each time.") { folder };
        command.SetAction(parsed =>
        {
            string target = parsed.GetRequiredValue(folder);
            PictureOutput.MakeFolder(target);
            foreach ((string name, Func<Picture> draw) in TexturePictures.All)
            {
                draw().Save(Path.Combine(target, name));
                console.Output.WriteLine(Path.Combine(target, name));
            }

            foreach ((string name, Func<Picture> draw) in ReliefPictures.All)
            {
                draw().Save(Path.Combine(target, name), new PictureSaveOptions { Encoding = TransferFunction.Linear });
                console.Output.WriteLine(Path.Combine(target, name));
            }

            foreach ((string name, Func<byte[]> draw) in CutOutPictures.All)
            {
                File.WriteAllBytes(Path.Combine(target, name), draw());
                console.Output.WriteLine(Path.Combine(target, name));
            }

            return ExitCode.Done;
        });
        return command;
    }
}
