using System.Globalization;
using System.Text;

namespace LabRaytracer.Tests.SceneFiles;

/// <summary>Every kind of mistake has its one line: file:line:column: what; allowed: ...</summary>
public sealed class SceneFileMistakeTests
{
    private const string File = "the path of a picture in the scene's folder or below, with '/' between folders";

    [Theory]
    [InlineData("""{"rendr": {}}""", "1:2: rendr: unknown key, did you mean 'render'; allowed: $schema, background, backgroundRotation, camera, lights, materials, objects, output, render, textures")]
    [InlineData("""{"zzzzzz": 1}""", "1:2: zzzzzz: unknown key; allowed: $schema, background, backgroundRotation, camera, lights, materials, objects, output, render, textures")]
    [InlineData("""{"render": {"width": "wide"}}""", "1:22: render.width: the text 'wide' does not fit; allowed: a whole number from 1 to 1048576")]
    [InlineData("""{"render": {"width": 0}}""", "1:22: render.width: the number 0 does not fit; allowed: a whole number from 1 to 1048576")]
    [InlineData("""{"render": {"height": 2.5}}""", "1:23: render.height: the number 2.5 does not fit; allowed: a whole number from 1 to 1048576")]
    [InlineData("""{"render": {"samples": 5}}""", "1:24: render.samples: 5 is not a square; allowed: square numbers, such as 4, 9")]
    [InlineData("""{"render": {"width": 1048576, "height": 1048576}}""", "1:41: render.height: a picture of 1048576 x 1048576 pixels is too large; allowed: at most 536870897 pixels")]
    [InlineData("""{"render": {"precision": "duoble"}}""", "1:26: render.precision: unknown word 'duoble', did you mean 'double'; allowed: double, single, exact")]
    [InlineData("""{"render": null}""", "1:12: render: null does not fit; allowed: an object { edgeSamples, errorBudget, height, maxDepth, maxSamples, pattern, pixelFilter, precision, samples, seed, width }")]
    [InlineData("""{"render": {"errorBudget": -1}}""", "1:28: render.errorBudget: the number -1 does not fit; allowed: a number at least 0 and at most 1000")]
    [InlineData("""{"render": {"edgeSamples": 0}}""", "1:28: render.edgeSamples: the number 0 does not fit; allowed: a whole number from 1 to 65536")]
    [InlineData("""{"render": {"maxSamples": 2}}""", "1:27: render.maxSamples: the number 2 does not fit; allowed: a whole number from 4 to 65536")]
    [InlineData("""{"render": {"pixelFilter": "gauss"}}""", "1:28: render.pixelFilter: unknown word 'gauss'; allowed: box, tent, mitchell")]
    [InlineData("""{"render": {"width": 9, "width": 8}}""", "1:25: the key 'width' is given twice in one object; allowed: each key once")]
    [InlineData("""{"render": {"width": 9, "wid\u0074h": 8}}""", "1:25: the key 'width' is given twice in one object; allowed: each key once")]
    [InlineData("""{"output": {"bitDepth": 9}}""", "1:25: output.bitDepth: 9 bits cannot be written; allowed: 8, 16")]
    [InlineData("""{"output": {"file": "../x.png"}}""", "1:21: output.file: '../x.png' is not a plain file name; allowed: a name without folders, such as earth.png")]
    [InlineData("""{"camera": {"eye": [0, 0, 1]}}""", "1:12: camera: the key 'type' is missing; allowed: perspective, orthographic, thinLens, fisheye, spherical")]
    [InlineData("""{"camera": {"type": "perspectiv", "eye": [0, 0, 1]}}""", "1:21: camera.type: unknown type 'perspectiv', did you mean 'perspective'; allowed: perspective, orthographic, thinLens, fisheye, spherical")]
    [InlineData("""{"camera": {"type": 3}}""", "1:21: camera.type: the number 3 does not fit; allowed: perspective, orthographic, thinLens, fisheye, spherical")]
    [InlineData("""{"camera": {"type": "perspective"}}""", "1:12: camera: the key 'eye' is missing; allowed: three numbers [x, y, z]")]
    [InlineData("""{"camera": {"type": "perspective", "eye": [0, 0]}}""", "1:43: camera.eye: a list of 2 values does not fit; allowed: three numbers [x, y, z]")]
    [InlineData("""{"camera": {"type": "perspective", "eye": [0, null, 1]}}""", "1:47: camera.eye[1]: null does not fit; allowed: a finite number")]
    [InlineData("""{"camera": {"type": "perspective", "eye": [0, 1e999, 1]}}""", "1:47: camera.eye[1]: 1e999 is beyond the range of numbers; allowed: a finite number")]
    [InlineData("""{"camera": {"type": "perspective", "eye": [0, 1e-999, 1]}}""", "1:47: camera.eye[1]: 1e-999 is beyond the range of numbers; allowed: a finite number")]
    [InlineData("""{"camera": {"type": "perspective", "eye": [0, 0, 1], "fieldOfViewDegrees": 180}}""", "1:76: camera.fieldOfViewDegrees: the number 180 does not fit; allowed: a number above 0 and below 180")]
    [InlineData("""{"camera": {"type": "perspective", "eye": [0, 0, 1], "up": [0, 0, 0]}}""", "1:60: camera.up: a list of 3 values does not fit; allowed: three numbers [x, y, z], not all 0")]
    [InlineData("""{"camera": {"type": "perspective", "eye": [0, 1, 0]}}""", "1:12: camera: the camera looks along its own up direction; allowed: an up direction beside the line from eye to target")]
    [InlineData("""{"camera": {"type": "orthographic", "height": 1, "eye": [0, 1, 0], "target": [0, 1, 0]}}""", "1:78: camera.target: the target is where the camera stands; allowed: any other point")]
    [InlineData("""{"background": "#12345"}""", "1:16: background: the text '#12345' does not fit; allowed: a number (grey), [r, g, b] of at least 0, \"#rrggbb\"")]
    [InlineData("""{"background": -1}""", "1:16: background: the number -1 does not fit; allowed: a number at least 0 and at most 1000000000")]
    [InlineData("""{"background": "earth"}""", "1:16: background: there is no texture 'earth'; allowed: names in 'textures', which is empty")]
    [InlineData("""{"textures": {"earth": {"type": "constant", "color": 1}}, "background": "erath"}""", "1:73: background: there is no texture 'erath', did you mean 'earth'; allowed: earth")]
    [InlineData("""{"textures": {"#a": {"type": "constant", "color": 1}}}""", "1:15: textures.#a: a name must not be empty or start with '#', as colours do")]
    [InlineData("""{"textures": {"a": {"type": "image", "file": "a.png"}}}""", "1:46: textures.a.file: the file 'a.png' does not exist; allowed: " + File)]
    [InlineData("""{"textures": {"a": {"type": "image", "file": "/etc/passwd"}}}""", "1:46: textures.a.file: the file '/etc/passwd' has an absolute path; allowed: " + File)]
    [InlineData("""{"textures": {"a": {"type": "image", "file": "C:/a.png"}}}""", "1:46: textures.a.file: the file 'C:/a.png' has an absolute path; allowed: " + File)]
    [InlineData("""{"textures": {"a": {"type": "image", "file": "x/../../a.png"}}}""", "1:46: textures.a.file: the file 'x/../../a.png' lies outside the scene's folder; allowed: " + File)]
    [InlineData("""{"textures": {"a": {"type": "image", "file": "x\\a.png"}}}""", "1:46: textures.a.file: the file 'x\\a.png' has a backslash in its name; allowed: " + File)]
    [InlineData("""{"textures": {"a": {"type": "image", "file": "http://x/a.png"}}}""", "1:46: textures.a.file: the file 'http://x/a.png' is an address of the network; allowed: " + File)]
    [InlineData("""{"textures": {"a": {"type": "image", "file": "x/COM1.png"}}}""", "1:46: textures.a.file: the file 'x/COM1.png' is a device; allowed: " + File)]
    [InlineData("""{"textures": {"a": {"type": "image", "file": "a\u0000.png"}}}""", "1:46: textures.a.file: the file 'a\\u0000.png' has a control character in its name; allowed: " + File)]
    [InlineData("""{"materials": {"m": {"diffuse": {"amount": 2}}}}""", "1:44: materials.m.diffuse.amount: the number 2 does not fit; allowed: a number at least 0 and at most 1")]
    [InlineData("""{"materials": {"m": {"indexOfRefraction": 0}}}""", "1:43: materials.m.indexOfRefraction: the number 0 does not fit; allowed: a number at least 0.01 and at most 100")]
    [InlineData("""{"objects": {}}""", "1:13: objects: an object { ... } does not fit; allowed: a list of objects in brackets [ ... ]")]
    [InlineData("""{"objects": [3]}""", "1:14: objects[0]: the number 3 does not fit; allowed: an object with 'shape': sphere, plane, quad, cylinder, disk, box, triangle, torus, cone, mesh")]
    [InlineData("""{"objects": [{"shape": "sphere", "radius": 0}]}""", "1:44: objects[0].radius: the number 0 does not fit; allowed: a number above 0")]
    [InlineData("""{"objects": [{"shape": "sphere", "material": "m"}]}""", "1:46: objects[0].material: there is no material 'm'; allowed: names in 'materials', which is empty")]
    [InlineData("""{"objects": [{"shape": "sphere", "castsShadows": "no"}]}""", "1:50: objects[0].castsShadows: the text 'no' does not fit; allowed: true, false")]
    [InlineData("""{"objects": [{"shape": "triangle", "a": [0, 0, 0], "b": [1, 1, 1], "c": [2, 2, 2]}]}""", "1:73: objects[0].c: the vertices lie on one line; allowed: three points that span an area")]
    [InlineData("""{"objects": [{"shape": "triangle", "a": [0, 0, 0], "b": [1, 1, 1], "c": [2, 0, 2], "uvs": [[0, 0]]}]}""", "1:91: objects[0].uvs: a list of 1; allowed: one for each of the three vertices")]
    [InlineData("""{"objects": [{"shape": "sphere", "transform": {"scale": [1, 0, 1]}}]}""", "1:57: objects[0].transform.scale: a factor is 0, or beyond what can be inverted; allowed: factors other than 0")]
    [InlineData("""{"objects": [{"shape": "sphere", "transform": [{"scale": 2, "translate": [0, 0, 1]}]}]}""", "1:58: objects[0].transform[0].scale: a step does one thing; allowed: translate, scale, rotateDegrees with or without axis, matrix")]
    [InlineData("""{"objects": [{"shape": "sphere", "transform": {}}]}""", "1:47: objects[0].transform: a step does one thing; allowed: translate, scale, rotateDegrees with or without axis, matrix")]
    [InlineData("""{"objects": [{"shape": "sphere", "transform": {"matrix": [1, 2]}}]}""", "1:58: objects[0].transform.matrix: a list of 2 values does not fit; allowed: 12 numbers: three rows of four")]
    [InlineData("""{"objects": [{"shape": "sphere", "transform": {"matrix": [1, 0, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0]}}]}""", "1:58: objects[0].transform.matrix: the matrix is singular: it flattens space; allowed: matrices that can be inverted")]
    [InlineData("""{"objects": [{"shape": "quad", "edgeV": [1, 0, 0], "edgeU": [2, 0, 0]}]}""", "1:61: objects[0].edgeU: the edges span no area; allowed: edges that are not parallel")]
    [InlineData("""{"objects": [{"shape": "box", "opposite": [-1, 1, 1]}]}""", "1:43: objects[0].opposite: the box is flat or too large; allowed: corners that differ in every coordinate")]
    [InlineData("""{"lights": [{"type": "point", "position": [0, 1, 0], "attenuation": [0, 0, 0]}]}""", "1:69: lights[0].attenuation: a list of 3 values does not fit; allowed: three numbers [constant, linear, quadratic] of at least 0, not all 0")]
    [InlineData("""{"lights": [{"type": "spot", "position": [0, 1, 0], "target": [0, 0, 0], "outerDegrees": 20, "innerDegrees": 30}]}""", "1:110: lights[0].innerDegrees: the inner angle is larger than the outer; allowed: angles up to outerDegrees")]
    [InlineData("""[1]""", "1:1: a list of 1 value does not fit; allowed: an object { $schema, background, backgroundRotation, camera, lights, materials, objects, output, render, textures }")]
    public void Read_OneMistake_IsOneLine(string json, string expected) => Assert.Equal("s.json:" + expected, SceneText.Message(json));

    [Theory]
    [InlineData("", "1:1: the file ends too early; allowed: a closed object { ... }")]
    [InlineData("{\n  \"render\": {", "2:14: the file ends too early; allowed: a closed object { ... }")]
    [InlineData("{\"a\": NaN}", "1:7: not a number of JSON; allowed: finite numbers such as 0.5 or 1e-3")]
    [InlineData("{\"a\": 'x'}", "1:7: texts and keys stand in double quotes; allowed: \"text\"")]
    [InlineData("{\n\t\"a\": 1\n\t\"b\": 2}", "3:2: unexpected '\"': a comma or colon may be missing before it")]
    [InlineData("{} x", "1:4: unexpected 'x': the JSON text breaks here")]
    [InlineData("{\"ąę\": ?}", "1:8: unexpected '?': the JSON text breaks here")]
    [InlineData("{\"a\": \"\\ud800\"}", "1:7: the text has half of a surrogate pair (\\ud800 to \\udfff); allowed: pairs, or the character itself")]
    public void Read_NotJson_NamesThePlace(string json, string expected) => Assert.Equal("s.json:" + expected, SceneText.Message(json));

    [Fact]
    public void Read_NotUtf8_NamesThePlace()
    {
        byte[] bytes = [.. "{\n \"a\": \""u8, 0xE9, .. "\"}"u8];
        SceneFileException failure = Assert.Throws<SceneFileException>(() => SceneText.Read(bytes));
        Assert.Equal("s.json:2:8: the file is not UTF-8 text; allowed: UTF-8; save the file with this encoding", failure.Message);
    }

    [Fact]
    public void Read_NestedTooDeeply_IsRefused()
    {
        string message = SceneText.Message(new string('[', 100_000));
        Assert.Equal("s.json:1:65: objects and arrays are nested too deeply; allowed: 64 levels", message);
    }

    [Fact]
    public void Read_ManyMistakes_AreAllReportedInOrder()
    {
        string json = """
            {
              // the order of the sections does not matter
              "objects": [
                { "shape": "spher" },
                { "shape": "sphere", "radius": -1, "colour": 3 },
              ],
              "render": { "width": 0, "width": 1 },
              "lights": [ { "type": "point" } ],
            }
            """;
        Assert.Equal(
            [
                (4, 16, "objects[0].shape: unknown shape 'spher', did you mean 'sphere'"),
                (5, 36, "objects[1].radius: the number -1 does not fit"),
                (5, 40, "objects[1].colour: unknown key"),
                (7, 24, "render.width: the number 0 does not fit"),
                (7, 27, "the key 'width' is given twice in one object"),
                (8, 15, "lights[0]: the key 'position' is missing"),
            ],
            Assert.Throws<SceneFileException>(() => SceneText.Read(json)).Errors.Select(error => (error.Line, error.Column, error.Message)));
    }

    [Fact]
    public void Read_TextureWithMistake_IsReportedOnceNotAtItsUses()
    {
        string json = """{"textures": {"a": {"type": "constant"}}, "materials": {"m": {"diffuse": "a"}}, "objects": [{"shape": "sphere", "material": "m"}]}""";
        Assert.Equal("s.json:1:20: textures.a: the key 'color' is missing; allowed: a number (grey), [r, g, b] of at least 0, \"#rrggbb\"", SceneText.Message(json));
    }

    [Fact]
    public void Read_ThousandsOfMistakes_AreCounted()
    {
        string json = "{\"objects\": [" + string.Join(',', Enumerable.Repeat("0", 1500)) + "]}";
        SceneFileException failure = Assert.Throws<SceneFileException>(() => SceneText.Read(json));
        Assert.Equal(1001, failure.Errors.Count);
        Assert.Equal("and 500 more mistakes", failure.Errors[^1].Message);
    }

    [Fact]
    public void Read_KeyWithLineBreaks_StaysOneLine()
    {
        string message = SceneText.Message("{\"a\\n\\u2028\\u202e\u001b\": 1}".Replace("\u001b", "\\u001b"));
        Assert.StartsWith("s.json:1:2: a\\u000a\\u2028\\u202e\\u001b: unknown key; allowed: ", message);
    }

    [Theory]
    [InlineData("{\r\n\"x\": 1}", 2)]
    [InlineData("{\r\"x\": 1}", 2)]
    [InlineData("{\n\n\"x\": 1}", 3)]
    [InlineData("\uFEFF{\"x\": 1}", 1)]
    public void Read_AnyLineEndsAndByteOrderMark_CountAsEditorsDo(string json, int line)
    {
        SceneFileError error = Assert.Throws<SceneFileException>(() => SceneText.Read(json)).Errors[0];
        Assert.Equal((line, line == 1 ? 2 : 1), (error.Line, error.Column));
    }

    [Fact]
    public void Read_CharactersOutsideAscii_CountAsUtf16()
    {
        SceneFileError error = Assert.Throws<SceneFileException>(() => SceneText.Read("{/* żółć 🌍 */ \"x\": 1}")).Errors[0];
        Assert.Equal(16, error.Column);
    }

    [Fact]
    public void Read_CommaDecimalCulture_ReadsPointsAndWritesPoints()
    {
        CultureInfo before = CultureInfo.CurrentCulture;
        try
        {
            CultureInfo.CurrentCulture = new CultureInfo("pl-PL");
            LoadedScene scene = SceneText.Read("""{"objects": [{"shape": "sphere", "radius": 1.5}]}""");
            Assert.Equal(1.5, ((Sphere)scene.Scene.Objects[0].Shape).Radius);
            Assert.Contains("a number at least 0.01 and", SceneText.Message("""{"materials": {"m": {"indexOfRefraction": -1.5}}}"""));
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Fact]
    public void Load_NoSuchFile_IsOneLine()
    {
        SceneFileException failure = Assert.Throws<SceneFileException>(() => SceneFile.Load("nowhere/scene.json"));
        Assert.Equal("nowhere/scene.json:1:1: there is no such scene file", failure.Message);
    }

    [Fact]
    public void Load_Folder_IsOneLine()
    {
        SceneFileException failure = Assert.Throws<SceneFileException>(() => SceneFile.Load(AppContext.BaseDirectory));
        Assert.EndsWith(":1:1: this is a folder, not a scene file", failure.Message);
    }

    [Fact]
    public void Load_LargerThanAllowed_IsRefusedBeforeReading()
    {
        using TestFolder folder = new();
        string path = folder.Write("a.json", "{ }");
        SceneFileException failure = Assert.Throws<SceneFileException>(() => SceneFile.Load(path, new SceneLoadOptions { MaxBytes = 2 }));
        Assert.EndsWith("a.json:1:1: the scene file has 3 bytes; allowed: at most 2 bytes", failure.Message);
    }

    [Fact]
    public void Load_MisspeltPicture_SuggestsTheFileBesideIt()
    {
        using TestFolder folder = new();
        folder.Write("textures/earth.png", "");
        string message = SceneText.Message("""{"textures": {"a": {"type": "image", "file": "textures/earht.png"}}}""", folder.Path);
        Assert.Contains("the file 'textures/earht.png' does not exist, did you mean 'earth.png'; allowed", message);
        Assert.Contains("'textures' is a folder; allowed", SceneText.Message("""{"textures": {"a": {"type": "image", "file": "textures"}}}""", folder.Path));
    }

    // The words of .NET never reach a user: each message must speak of the file.
    [Fact]
    public void Read_RandomMutations_FailOnlyWithSceneFileException()
    {
        byte[] seed = Encoding.UTF8.GetBytes(SceneFileFeatureTests.EveryKey);
        Random random = new(20260401);
        string[] pieces = ["null", "1e999", "-1", "[]", "{}", "\"\"", "\"x\"", "true", ",", ":", "\"\\ud800\"", "NaN", "// ", "/*", "0.5", "1e-400", "[[[[", "\u0000", "é"];
        int refused = 0;
        for (int i = 0; i < 3000; i++)
        {
            List<byte> bytes = [.. seed];
            for (int n = random.Next(1, 4); n > 0; n--)
            {
                int at = random.Next(bytes.Count), length = Math.Min(random.Next(12), bytes.Count - at);
                bytes.RemoveRange(at, length);
                bytes.InsertRange(at, random.Next(3) == 0 ? [(byte)random.Next(256)] : Encoding.UTF8.GetBytes(pieces[random.Next(pieces.Length)]));
            }

            try
            {
                SceneText.Read([.. bytes]);
            }
            catch (SceneFileException failure)
            {
                refused++;
                Assert.All(failure.Errors, error => Assert.DoesNotMatch(@"[\n\r]|System\.|`\d|Exception|Parameter", error.ToString()));
            }
        }

        Assert.InRange(refused, 1000, 3000);
    }
}
