using System.Text;

namespace LabRaytracer.Tests.SceneFiles;

public sealed class ObjFileTests
{
    [Theory]
    [InlineData("f 1 2 3")]
    [InlineData("f -3 -2 -1")]
    [InlineData("f 1/1 2/2 3/3")]
    [InlineData("f 1//1 2//1 3//-1")]
    [InlineData("f 1/1/1 2/2/1 -1/-1/1")]
    [InlineData("  f   1\t2 \\\n 3  # a comment")]
    public void Read_EveryWayToWriteACorner_IsTheSameTriangle(string face)
    {
        ObjReader lines = Read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\n" + face);
        Assert.Equal([0, 1, 2], lines.Data.PositionOf);
    }

    [Fact]
    public void Read_CornersWithAllIndices_KeepsThem()
    {
        ObjData data = Read("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0.5 0.25 9\nvt 1\nvn 0 0 2\nvn 1 0 0\nf 1/2/1 2/1/2 3//1").Data;
        Assert.Equal([0.5, 0.25, 1, 0], data.Uvs);
        Assert.Equal([1, 0, -1], data.UvOf);
        Assert.Equal([0, 1, 0], data.NormalOf);
    }

    [Fact]
    public void Read_NegativeIndices_CountFromTheLinesSoFar()
    {
        ObjData data = Read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4 -3 -1").Data;
        Assert.Equal([0, 1, 2, 0, 1, 3], data.PositionOf);
    }

    [Fact]
    public void Read_WeightsAndColorsAfterPositions_ArePassedOver() =>
        Assert.Equal([1, 2, 3, 4, 5, 6, 7, 8, 9], Read("v 1 2 3 1.0\nv 4 5 6 0.1 0.2 0.3\nv 7 8 9\nf 1 2 3").Data.Positions);

    [Fact]
    public void Read_WordsOfOtherElements_ArePassedOver() =>
        Assert.Equal(1, Read("o thing\ng a b\ns off\nl 1 2\np 1\nvp 0 0\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nend").Data.Counts.Triangles);

    [Fact]
    public void Read_ConvexQuad_IsAFan() => Assert.Equal([0, 1, 2, 0, 2, 3], Read("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4").Data.PositionOf);

    [Theory]
    [InlineData("0 0 0, 2 0 0, 2 2 0, 1 0.5 0", 1.5)] // a dart: area by the shoelace formula
    [InlineData("0 0 0, 3 0 0, 3 3 0, 2 3 0, 2 1 0, 1 1 0, 1 3 0, 0 3 0", 7)] // a U: 3 x 3 without 1 x 2
    [InlineData("0 0 0, 0 0 3, 0 3 3, 0 3 2, 0 1 2, 0 1 1, 0 3 1, 0 3 0", 7)] // the same U, seen along x from behind
    [InlineData("0 0 0, 1 0 0, 2 0 0, 2 1 0, 2 2 0, 0 2 0", 4)] // corners in the middle of edges
    [InlineData("0 0 0, 4 0 0, 4 4 0, 0 4 0, 0 0 0, 1 1 0, 1 3 0, 3 3 0, 3 1 0, 1 1 0", 12)] // a hole, reached by a bridge
    public void Read_Polygon_IsCutIntoTrianglesThatCoverItOnce(string corners, double area)
    {
        string[] vertices = corners.Split(", ");
        ObjData data = Read(string.Concat(vertices.Select(vertex => $"v {vertex}\n")) + "f " + string.Join(' ', Enumerable.Range(1, vertices.Length))).Data;
        Assert.Equal(vertices.Length - 2, data.Counts.Triangles);
        double sum = 0;
        Vector3D all = Vector3D.Zero;
        for (int at = 0; at < data.PositionOf.Length; at += 3)
        {
            Point3D a = data.Position(data.PositionOf[at]);
            Vector3D cross = Vector3D.Cross(data.Position(data.PositionOf[at + 1]) - a, data.Position(data.PositionOf[at + 2]) - a) / 2;
            sum += cross.Length;
            all += cross;
        }

        // No triangle is turned over or lies outside: the areas add up without signs as they do with them.
        Assert.Equal(area, sum, 12);
        Assert.Equal(area, all.Length, 12);
    }

    [Fact]
    public void Read_FaceWithManyCorners_IsCutOrRefusedSoon()
    {
        // A convex face is a fan however many corners it has; a comb of 1200 teeth is more than can be cut in reasonable time.
        string circle = string.Concat(Enumerable.Range(0, 3000).Select(i => FormattableString.Invariant($"v {Math.Cos(i / 480.0)} {Math.Sin(i / 480.0)} 0\n")));
        string comb = string.Concat(Enumerable.Range(0, 2400).Select(i => $"v {i} {(i % 2 == 0 ? 1 : 2)} 0\n")) + "v 2400 0 0\nv 0 0 0\n";
        Assert.Equal(2998, Read(circle + "f " + string.Join(' ', Enumerable.Range(1, 3000))).Data.Counts.Triangles);
        Assert.Equal(
            "m.obj:2403:1: a concave face with 2402 corners; allowed: concave faces with up to 2048 corners",
            Assert.Throws<SceneFileException>(() => Read(comb + "f " + string.Join(' ', Enumerable.Range(1, 2402)))).Message);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(7)]
    [InlineData(64)]
    public void Read_AnyChunkSize_IsTheSame(int chunkBytes)
    {
        StringBuilder text = new("\uFEFF# grid\r\nmtllib a.mtl\r\n");
        for (int i = 0; i < 50; i++)
        {
            text.Append($"v {i} 0 0\r\nv {i} 1 \\\r\n {i}\r\nvt 0.{i} 1\r\nusemtl m{i % 3}\r\n");
            text.Append(i < 2 ? "\r\n" : "f -1/-1 -2 \\\n -3/-2 -4\r\n");
        }

        ObjReader whole = Read(text.ToString()), cut = Read(text.ToString(), chunkBytes);
        Assert.Equal(whole.Data.Positions, cut.Data.Positions);
        Assert.Equal(whole.Data.PositionOf, cut.Data.PositionOf);
        Assert.Equal(whole.Data.UvOf, cut.Data.UvOf);
        Assert.Equal(whole.Materials, cut.Materials);
        Assert.Equal(96, cut.Data.Counts.Triangles);
    }

    [Theory]
    [InlineData("v 0 0", "1:6: the line ends too early; allowed: v with three numbers x y z up to 1e18")]
    [InlineData("v 0 zero 0", "1:5: 'zero' does not fit; allowed: v with three numbers x y z up to 1e18")]
    [InlineData("v 0 nan 0", "1:5: 'nan' does not fit; allowed: v with three numbers x y z up to 1e18")]
    [InlineData("v 0 1e999 0", "1:5: '1e999' does not fit; allowed: v with three numbers x y z up to 1e18")]
    [InlineData("vt x", "1:4: 'x' does not fit; allowed: vt with one to three finite numbers u v w")]
    [InlineData("vn 1 2", "1:7: the line ends too early; allowed: vn with three numbers x y z up to 1e18")]
    [InlineData("\n vq 1", "2:2: unknown word 'vq'; allowed: v, vt, vn, f, usemtl, mtllib, o, g, s, l, p")]
    [InlineData("v 0 0 0\nf 1 1", "2:1: a face with 2 corners; allowed: f with three corners or more")]
    [InlineData("v 0 0 0\nf 1 1 2", "2:7: there is no v with the index 2; allowed: 1 to 1, or -1 to -1")]
    [InlineData("v 0 0 0\nf 1 1 0", "2:7: there is no v with the index 0; allowed: 1 to 1, or -1 to -1")]
    [InlineData("v 0 0 0\nf 1 1 -2", "2:7: there is no v with the index -2; allowed: 1 to 1, or -1 to -1")]
    [InlineData("v 0 0 0\nf 1 1/1 1", "2:5: there is no vt with the index 1; allowed: none, there is no vt")]
    [InlineData("v 0 0 0\nf 1 1//1 1", "2:5: there is no vn with the index 1; allowed: none, there is no vn")]
    [InlineData("v 0 0 0\nf 1 1/ 1", "2:5: '1/' is not a corner of a face; allowed: v, v/vt, v//vn, v/vt/vn")]
    [InlineData("v 0 0 0\nf 1 a 1", "2:5: 'a' is not a corner of a face; allowed: v, v/vt, v//vn, v/vt/vn")]
    [InlineData("v 0 0 0\nf 1 99999999999 1", "2:5: '99999999999' is not a corner of a face; allowed: v, v/vt, v//vn, v/vt/vn")]
    [InlineData("v 0 0 0", "1:1: the file has no faces; allowed: at least one line f")]
    [InlineData("", "1:1: the file has no faces; allowed: at least one line f")]
    public void Read_Mistake_IsOneLine(string text, string expected) =>
        Assert.Equal("m.obj:" + expected, Assert.Throws<SceneFileException>(() => Read(text)).Message);

    [Fact]
    public void Read_ManyMistakes_AreAllReported()
    {
        SceneFileException failure = Assert.Throws<SceneFileException>(() => Read("v 1\nvt\nx\nf 1 2 3"));
        Assert.Equal([1, 2, 3, 4, 4], failure.Errors.Select(error => error.Line));
    }

    [Fact]
    public void Load_Materials_GiveOneMeshEach()
    {
        using TestFolder folder = new();
        folder.Write("two words.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
        string path = folder.Write("a.obj", """
            mtllib two words.mtl
            v 0 0 0
            v 1 0 0
            v 0 1 0
            v 0 0 1
            vn 0 0 1
            f 1 2 3
            usemtl red
            f 2//1 3//1 4//1
            usemtl blue
            f 1 3 4
            usemtl red
            f 1 2 4
            """);
        ObjScene scene = ObjFile.Load(path);
        Assert.Equal([("", 1), ("red", 2), ("blue", 1)], scene.Parts.Select(part => (part.MaterialName, part.Mesh.TriangleCount)));
        Assert.Null(scene.Parts[0].Material);
        Assert.Equal(new Intensity(0, 0, 1), scene.Parts[2].Material!.Diffuse.Value);
        Assert.Same(scene.Materials["red"], scene.Parts[1].Material);
        Assert.Equal(new Point3D(0, 0, 1), scene.Parts[1].Mesh.Data.Position(1, 2));
        Assert.True(scene.SourceMap.TryLocate(scene.Materials["blue"], out SceneLocation location));
        Assert.Equal((3, 1), (location.Line, location.Column));
    }

    [Fact]
    public void Load_TriangleWithoutArea_IsLeftOut()
    {
        using TestFolder folder = new();
        TriangleMesh mesh = ObjFile.Load(folder.Write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2")).Parts[0].Mesh;
        Assert.Equal((2, 1), (mesh.TriangleCount, mesh.DegenerateCount));
    }

    [Fact]
    public void Load_NormalsHereAndThere_TrianglesWithoutAreFlat()
    {
        using TestFolder folder = new();
        string path = folder.Write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvn 0 0 0\nf 1//1 2//1 3//1\nf 1//2 3//1 4//1\nf 1 4 2");
        TriangleMesh mesh = ObjFile.Load(path).Parts[0].Mesh;
        Ray ray = new(new Point3D(5, 0.1, 0.1), new Vector3D(-1, 0, 0));
        Assert.True(mesh.Intersect(ray, 100, out Hit hit));
        Assert.Equal(1, Math.Abs(mesh.SurfaceAt(ray, hit).ShadingNormal.X), 12);
    }

    [Fact]
    public void Load_Scene_PutsMeshesIntoTheScene()
    {
        using TestFolder folder = new();
        folder.Write("meshes/a.mtl", "newmtl m\nmap_Kd -s 2 3 -o 0.5 0.25 -clamp on ..\\pictures\\red dot.ppm\n");
        folder.Write("pictures/red dot.ppm", "P3 1 1 255 255 0 0");
        folder.Write("meshes/a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n");
        string path = folder.Write("s.json", """
            { "objects": [
                { "shape": "mesh", "file": "meshes/a.obj", "name": "first" },
                { "shape": "mesh", "file": "meshes/a.obj" },
                { "shape": "mesh", "file": "meshes/a.obj", "material": { "diffuse": 0.5 } } ] }
            """);
        IList<SceneObject> objects = SceneFile.Load(path).Scene.Objects;
        Assert.Equal(3, objects.Count);
        Assert.Same(objects[0].Shape, objects[1].Shape);
        TextureSlot diffuse = objects[0].Material.Diffuse;
        Texture picture = Assert.IsType<Texture>(diffuse.Texture);
        Assert.Equal((TextureWrap.Clamp, TextureWrap.Clamp), (picture.Sampling.WrapU!.Value, picture.Sampling.WrapV!.Value));
        Assert.Equal(new UvTransform(new TextureCoordinate(0.5, 0.25), 0, new TextureCoordinate(2, 3), new TextureCoordinate(0, 0)), diffuse.Transform);
        Assert.Equal(Intensity.Grey(0.5f), objects[2].Material.Diffuse.Value);
        Assert.Equal("first", objects[0].Name);
    }

    [Fact]
    public void Load_SceneWithWrongMesh_NamesTheLinesOfBothFiles()
    {
        using TestFolder folder = new();
        folder.Write("a.obj", "v 0 0 0\nf 1 2 3\n");
        string path = folder.Write("s.json", """{ "render": { "width": 0 }, "objects": [ { "shape": "mesh", "file": "a.obj" }, { "shape": "mesh", "file": "a.obj" } ] }""");
        SceneFileException failure = Assert.Throws<SceneFileException>(() => SceneFile.Load(path));
        Assert.Equal([("s.json", 1), ("a.obj", 2), ("a.obj", 2)], failure.Errors.Select(error => (Path.GetFileName(error.File), error.Line)));
        Assert.Equal(Path.Combine(folder.Path, "a.obj"), failure.Errors[1].File);
    }

    [Fact]
    public void Read_RandomMutations_FailOnlyWithSceneFileException()
    {
        byte[] seed = Encoding.UTF8.GetBytes("v 0 0 0\nv 1.5 0 0\nv 0 1 -2e-3\nv 1 1 1\nvt 0 1\nvn 0 0 1\nusemtl a\nf 1/1/1 2 3//-1 4\nf 1 2 3 \\\n 4\n# end\r\n");
        byte[][] pieces = [.. new[] { "\\\n", "f ", "v ", "/", "//", "-1", "99999999999", "1e400", "\r", "\n", "#", "f 1 2 3 4 1 2\n", "nan", "usemtl" }.Select(Encoding.UTF8.GetBytes)];
        Random random = new(99);
        int refused = 0;
        for (int i = 0; i < 3000; i++)
        {
            List<byte> bytes = [.. seed];
            for (int n = random.Next(1, 4); n > 0; n--)
            {
                int at = random.Next(bytes.Count), length = Math.Min(random.Next(6), bytes.Count - at);
                bytes.RemoveRange(at, length);
                bytes.InsertRange(at, random.Next(3) == 0 ? [(byte)random.Next(256)] : pieces[random.Next(pieces.Length)]);
            }

            try
            {
                ObjMeshes.Make(ObjReader.Read(new SceneSource("m.obj", [.. bytes]), random.Next(8, 100)), new Dictionary<string, Material>());
            }
            catch (SceneFileException)
            {
                refused++;
            }
        }

        Assert.InRange(refused, 1000, 2990);
    }

    private static ObjReader Read(string text, int chunkBytes = 1 << 20) => ObjReader.Read(new SceneSource("m.obj", Encoding.UTF8.GetBytes(text)), chunkBytes);
}
