namespace LabRaytracer.Tests.SceneFiles;

/// <summary>Scenes whose pictures are not there: refused, or shown with a checker.</summary>
public sealed class MissingPictureTests
{
    [Fact]
    public void Load_ByDefault_NamesThePlaceOfTheMissingFile()
    {
        using TestFolder folder = new();
        string scene = folder.Write("s.json", """{"background": {"texture": {"type": "image", "file": "gone.png"}}}""");
        Assert.Equal(
            $"{scene}:1:54: background.texture.file: the file 'gone.png' does not exist; allowed: the path of a picture in the scene's folder or below, with '/' between folders",
            Assert.Throws<SceneFileException>(() => SceneFile.Load(scene)).Message);
    }

    [Fact]
    public void Load_WithChecker_WarnsOnceAFileAndShowsMagenta()
    {
        using TestFolder folder = new();
        folder.Write("bad.png", "x");
        folder.Write("m.mtl", "newmtl a\nmap_Kd lost.png\n");
        folder.Write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n");
        string scene = folder.Write("s.json", """
            {"textures": {"a": {"type": "image", "file": "gone.png"}, "b": {"type": "image", "file": "gone.png", "filter": "ewa"}, "c": {"type": "image", "file": "bad.png"}},
             "objects": [{"shape": "sphere", "material": {"diffuse": "a", "emission": "b", "specular": "c"}}, {"shape": "mesh", "file": "m.obj"}]}
            """);
        List<SceneFileError> warnings = [];
        LoadedScene loaded = SceneFile.Load(scene, new SceneLoadOptions { MissingPictures = MissingPictures.Checker, Warned = warnings.Add });
        Assert.Equal(
            [(scene, 1, 46, "the file 'gone.png' does not exist; a checker stands in"), (System.IO.Path.Combine(folder.Path, "m.mtl"), 2, 8, "the file 'lost.png' does not exist; a checker stands in")],
            warnings.Select(warning => (System.IO.Path.GetFullPath(warning.File), warning.Line, warning.Column, warning.Message)));
        var texture = (Texture)loaded.Scene.Objects[0].Material.Specular.Texture!;
        Assert.Equal((64, 64), (texture.Width, texture.Height));
        Assert.Equal(3, warnings.Count);
        Assert.Contains("the format is not known", warnings[2].Message, StringComparison.Ordinal);
        Assert.Equal((1, 151), (warnings[2].Line, warnings[2].Column));

        // Cells of 8 texels; magenta at the top left.
        Assert.Equal((new Intensity(1, 0, 1), Intensity.Black), (texture.ColorMap[0, 63], texture.ColorMap[8, 63]));
        Assert.Equal((Intensity.Black, new Intensity(1, 0, 1)), (texture.ColorMap[0, 55], texture.ColorMap[8, 55]));
    }

    /// <summary>A checker hides no other mistake: paths outside of the folder and folders stay errors.</summary>
    [Theory]
    [InlineData("/etc/x.png", "absolute path")]
    [InlineData("../x.png", "outside the scene's folder")]
    [InlineData("sub", "is a folder")]
    public void Load_WithChecker_RefusesOtherMistakes(string file, string why)
    {
        using TestFolder folder = new();
        folder.Write("sub/x.txt", "");
        string scene = folder.Write("s.json", """{"background": {"texture": {"type": "image", "file": "NAME"}}}""".Replace("NAME", file, StringComparison.Ordinal));
        SceneFileException refused = Assert.Throws<SceneFileException>(() => SceneFile.Load(scene, new SceneLoadOptions { MissingPictures = MissingPictures.Checker }));
        Assert.Contains(why, refused.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void ColorRule_Files_SaysWhatWasDecided()
    {
        using TestFolder folder = new();
        string path = System.IO.Path.Combine(folder.Path, "a.png");
        new Picture(2, 2).Save(path, new PictureSaveOptions { Encoding = TransferFunction.Linear });
        Texture texture = Texture.Load(path);
        Assert.Equal("linear (gAMA chunk)", texture.ColorRule);
        Assert.Equal("sRGB (asked for)", texture.With(new SamplingOptions { ColorSpace = ColorSpace.Srgb }).ColorRule);
        Assert.Equal("linear (ColorMap)", new Texture(2, 2).ColorRule);
    }
}
