namespace LabRaytracer.Tests.SceneFiles;

public sealed class MtlTests
{
    private const string Triangle = "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n";

    [Fact]
    public void Load_Coefficients_AreTaken()
    {
        Material material = Load("""
            # comment
            newmtl m
            Ka 0.1 0.2 0.3
            Kd 0.5
            Ks 1 0.5 0.25
            Ke 0 0 2
            Ns 96.5
            d 0.75
            Tf 1 0.5 0
            Ni 1.45
            illum 7
            sharpness 60
            """);
        Assert.Equal("m", material.Name);
        Assert.Equal((new Intensity(0.1f, 0.2f, 0.3f), Intensity.Grey(0.5f)), (material.Ambient!.Value, material.Diffuse.Value));
        Assert.Equal((new Intensity(1, 0.5f, 0.25f), new Intensity(0, 0, 2)), (material.Specular.Value, material.Emission.Value));
        Assert.Equal((96.5f, 1.45f), (material.Shininess.Value, material.IndexOfRefraction.Value));
        Assert.Equal((new Intensity(0.25f, 0.125f, 0), new Intensity(1, 0.5f, 0.25f)), (material.Transparency.Value, material.Reflection.Value));
        Assert.Equal(FresnelModel.Dielectric, material.Fresnel);
    }

    [Theory]
    [InlineData(0, 0f, 0f, 0f, 1f)]
    [InlineData(1, 1f, 0f, 0f, 0f)]
    [InlineData(2, 1f, 0.5f, 0f, 0f)]
    [InlineData(3, 1f, 0.5f, 0.5f, 0f)]
    public void Load_Illumination_ChoosesTheTerms(int model, float diffuse, float specular, float reflection, float emission)
    {
        Material material = Load($"newmtl m\nKd 1\nKs 0.5\nillum {model}\n");
        Assert.Equal(
            (diffuse, specular, reflection, emission),
            (material.Diffuse.Value.R, material.Specular.Value.R, material.Reflection.Value.R, material.Emission.Value.R));
    }

    [Fact]
    public void Load_Maps_AreTaken()
    {
        Material material = Load("newmtl m\nKd 0.5 0.5 0.5\nmap_Kd -mm 0 1 -bm 0.5 -blendu on p.ppm\nmap_Ks p.ppm\nmap_Ka p.ppm\nmap_Ke p.ppm\nNs 20\nmap_Ns -imfchan g p.ppm\nmap_refl no.png\n");
        Assert.Equal(Intensity.Grey(0.5f), material.Diffuse.Value);
        Assert.All([material.Diffuse, material.Specular, material.Ambient!, material.Emission], slot => Assert.IsType<Texture>(slot.Texture));
        Assert.Equal((20f, TextureChannel.Green), (material.Shininess.Value, material.Shininess.Channel));
        Assert.Equal(TextureWrap.Repeat, ((Texture)material.Diffuse.Texture!).Sampling.WrapU);
    }

    [Theory]
    [InlineData("d 0.75", 0.75f, 0f)]
    [InlineData("Tr 0.75\nillum 2", 0.25f, 0f)]
    [InlineData("d 0.75\nillum 4", 1f, 0.25f)]
    [InlineData("d 0.75\nillum 9", 1f, 0.25f)]
    public void Load_Dissolve_IsOpacityUnlessTheModelIsGlass(string lines, float opacity, float transparency)
    {
        Material material = Load("newmtl m\n" + lines + "\n");
        Assert.Equal((opacity, transparency), (material.Opacity.Value, material.Transparency.Value.G));
    }

    [Theory]
    [InlineData("map_d p.ppm", TextureChannel.Luminance)]
    [InlineData("map_d -imfchan m p.ppm", TextureChannel.Alpha)]
    [InlineData("map_Kd p.ppm\nmap_d p.ppm", TextureChannel.Alpha)]
    [InlineData("map_d -imfchan l p.ppm\nmap_Kd p.ppm", TextureChannel.Luminance)]
    public void Load_DissolveMap_IsTheOpacitysTexture(string lines, TextureChannel channel)
    {
        ScalarSlot opacity = Load("newmtl m\nd 0.5\n" + lines + "\n").Opacity;
        Assert.IsType<Texture>(opacity.Texture);
        Assert.Equal((0.5f, channel), (opacity.Value, opacity.Channel));
    }

    [Theory]
    [InlineData("bump p.ppm", 0.02f)]
    [InlineData("map_bump -bm 0.5 -imfchan r p.ppm", 0.5f)]
    [InlineData("map_Bump -bm -0.25 p.ppm", -0.25f)]
    public void Load_Bump_IsAHeight(string line, float height)
    {
        ScalarSlot bump = Load("newmtl m\n" + line + "\n").Bump!;
        Assert.IsType<Texture>(bump.Texture);
        Assert.Equal(height, bump.Value);
    }

    [Fact]
    public void Load_Norm_IsANormalMap()
    {
        Material material = Load("newmtl m\nnorm -s 2 3 p.ppm\n");
        Assert.Null(material.Bump);
        Assert.Equal(new TextureCoordinate(2, 3), material.NormalMap!.Transform.Apply(new TextureCoordinate(1, 1)));
    }

    [Theory]
    [InlineData("newmtl m\nKd 1 x 1", "2:6: 'x' does not fit; allowed: one or three numbers of at least 0")]
    [InlineData("newmtl m\nd 2", "2:3: '2' does not fit; allowed: a number from 0 to 1")]
    [InlineData("newmtl m\nNi nan", "2:4: 'nan' does not fit; allowed: a number from 0.01 to 100")]
    [InlineData("newmtl m\nmap_Kd q.ppm", "2:8: the file 'q.ppm' does not exist, did you mean 'p.ppm'; allowed: the path of a picture, relative to the folder of this file")]
    [InlineData("newmtl m\nmap_Kd -clmp on p.ppm", "2:8: '-clmp' does not fit; allowed: " + "-s u v w, -o u v w, -clamp on|off, -imfchan r|g|b|l|m|z, -blendu, -blendv, -cc on|off, -bm, -boost, -texres number, -mm base gain, -t u v w")]
    [InlineData("newmtl m\nmap_Kd C:\\p.ppm", "2:8: the file 'C:/p.ppm' has an absolute path; allowed: the path of a picture, relative to the folder of this file")]
    [InlineData("newmtl m\nmap_Kq p.ppm", "2:1: unknown word 'map_Kq', did you mean 'map_Kd'; allowed: newmtl, Kd, Ks, Ka, Ke, Tf, Ns, d, Tr, Ni, illum, map_Kd, map_Ks, map_Ka, map_Ke, map_Ns, map_d, map_bump, bump, norm")]
    public void Load_Mistake_IsOneLine(string mtl, string expected)
    {
        SceneFileError error = Assert.Throws<SceneFileException>(() => Load(mtl)).Errors.Single();
        Assert.Equal(expected, error.ToString()[(error.ToString().IndexOf("a.mtl:", StringComparison.Ordinal) + 6)..]);
    }

    [Fact]
    public void Load_UnknownMaterial_IsAMistakeOfTheMesh()
    {
        SceneFileError error = Assert.Throws<SceneFileException>(() => Load("newmtl n\nKd 1\n")).Errors.Single();
        Assert.EndsWith("a.obj:5:1: there is no material 'm', did you mean 'n'; allowed: n", error.ToString());
    }

    [Fact]
    public void Load_MissingLibrary_IsAMistakeOfTheMesh()
    {
        using TestFolder folder = new();
        string path = folder.Write("a.obj", Triangle);
        SceneFileError error = Assert.Throws<SceneFileException>(() => ObjFile.Load(path)).Errors.Single();
        Assert.EndsWith("a.obj:1:1: the file 'a.mtl' does not exist; allowed: MTL files in the folder of the OBJ file", error.ToString());
    }

    private static Material Load(string mtl)
    {
        using TestFolder folder = new();
        folder.Write("p.ppm", "P3 1 1 255 255 0 0");
        folder.Write("a.mtl", mtl);
        return ObjFile.Load(folder.Write("a.obj", Triangle)).Materials["m"];
    }
}
