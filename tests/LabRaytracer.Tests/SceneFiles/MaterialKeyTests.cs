namespace LabRaytracer.Tests.SceneFiles;

/// <summary>Keys of materials beyond the lighting model: opacity, relief, layers, light maps, two sides.</summary>
public sealed class MaterialKeyTests
{
    private const string Textures = """ "textures": { "t": { "type": "grid" } }, """;

    [Fact]
    public void Read_Numbers_AreTaken()
    {
        Material material = Read("""{ "opacity": { "value": 0.5, "texture": "t", "channel": "alpha" }, "occlusion": { "texture": "t", "amount": 0.25 }, "bump": { "value": -0.125, "texture": "t", "channel": "green" } }""");
        Assert.Equal((0.5f, TextureChannel.Alpha), (material.Opacity.Value, material.Opacity.Channel));
        Assert.Equal((1, 0.25f), (material.Occlusion.Value, material.Occlusion.Amount));
        Assert.Equal((-0.125f, TextureChannel.Green), (material.Bump!.Value, material.Bump.Channel));
        Assert.All([material.Opacity, material.Occlusion, material.Bump], slot => Assert.IsType<GridTexture>(slot.Texture));
    }

    [Fact]
    public void Read_NothingOfThem_IsPlain()
    {
        Material material = Read("{}");
        Assert.Equal((1, 1), (material.Opacity.Value, material.Occlusion.Value));
        Assert.Equal((Intensity.Black, LightMapMode.Add), (material.LightMap.Value, material.LightMapMode));
        Assert.Null(material.Bump);
        Assert.Null(material.NormalMap);
        Assert.Null(material.Inside);
        Assert.Empty(material.Diffuse.Layers);
    }

    [Fact]
    public void Read_BareNamesAndNumbers_StandForTheSlot()
    {
        Material material = Read("""{ "opacity": "t", "bump": "t", "normalMap": "t", "lightMap": "t", "lightMapMode": "replace", "occlusion": 0.5 }""");
        Assert.Equal((1, TextureChannel.Luminance), (material.Opacity.Value, material.Opacity.Channel));
        Assert.Equal((1, 0.5f, 1), (material.Bump!.Value, material.Occlusion.Value, material.NormalMap!.Strength));
        Assert.Equal((Intensity.White, LightMapMode.Replace), (material.LightMap.Value, material.LightMapMode));
    }

    [Fact]
    public void Read_NormalMap_IsTaken()
    {
        NormalMap map = Read("""{ "normalMap": { "texture": "t", "strength": 0.5, "flipGreen": true, "rebuildZ": true, "mapping": "box", "transform": { "scale": 2 } } }""").NormalMap!;
        Assert.Equal((0.5f, true, true), (map.Strength, map.FlipGreen, map.RebuildZ));
        Assert.IsType<BoxMapping>(map.Mapping);
        Assert.Equal(new TextureCoordinate(2, 2), map.Transform.Apply(new TextureCoordinate(1, 1)));
    }

    [Fact]
    public void Read_Layers_AreTaken()
    {
        IReadOnlyList<TextureLayer> layers = Read("""
            { "diffuse": { "value": 0.5, "layers": [
                { "texture": "t", "opacity": 0.25, "blend": "multiply", "mapping": "disk", "transform": { "offset": [0, 1] } },
                { "texture": { "type": "constant", "color": 1 }, "place": { "center": [0.5, 0.25], "size": [0.5, 0.25], "rotateDegrees": 90 } } ] } }
            """).Diffuse.Layers;
        Assert.Equal((2, 0.25f, BlendMode.Multiply, false), (layers.Count, layers[0].Opacity, layers[0].Blend, layers[0].IsDecal));
        Assert.IsType<DiskMapping>(layers[0].Mapping);
        Assert.Equal((1, BlendMode.Replace, true), (layers[1].Opacity, layers[1].Blend, layers[1].IsDecal));

        // Half its width to the right of the centre, turned: half its width above it.
        TextureCoordinate right = layers[1].Transform.Apply(new TextureCoordinate(0.5, 0.5));
        Assert.Equal((1, 0.5), (right.U, right.V));
    }

    [Theory]
    [InlineData("""{ "materials": { "a": { "diffuse": 0.25 }, "b": { "inside": "a" } }, "objects": [{ "shape": "sphere", "material": "b" }] }""")]
    [InlineData("""{ "materials": { "b": { "inside": "a" }, "a": { "diffuse": 0.25 } }, "objects": [{ "shape": "sphere", "material": "b" }] }""")]
    public void Read_Inside_IsAMaterialAboveOrBelow(string json)
    {
        Material material = SceneText.Read(json).Scene.Objects[0].Material;
        Assert.Equal(("b", "a", new Intensity(0.25f, 0.25f, 0.25f)), (material.Name, material.Inside!.Name, material.Inside.Diffuse.Value));
    }

    [Theory]
    [InlineData("""{"materials": {"m": {"opacity": 1.5}}}""", "1:33: materials.m.opacity: the number 1.5 does not fit; allowed: a number at least 0 and at most 1")]
    [InlineData("""{"materials": {"m": {"occlusion": -1}}}""", "1:35: materials.m.occlusion: the number -1 does not fit; allowed: a number at least 0 and at most 1")]
    [InlineData("""{"materials": {"m": {"bump": "hills"}}}""", "1:30: materials.m.bump: there is no texture 'hills'; allowed: names in 'textures', which is empty")]
    [InlineData("""{"materials": {"m": {"lightMapMode": "ad"}}}""", "1:38: materials.m.lightMapMode: unknown word 'ad', did you mean 'add'; allowed: add, replace")]
    [InlineData("""{"materials": {"m": {"normalMap": 3}}}""", "1:35: materials.m.normalMap: the number 3 does not fit; allowed: the name of a texture, an object { texture, strength, flipGreen, ... }")]
    [InlineData("""{"materials": {"m": {"normalMap": {"strength": 2}}}}""", "1:35: materials.m.normalMap: the key 'texture' is missing; allowed: the name of a texture, or a texture { \"type\": ... }")]
    [InlineData("""{"materials": {"m": {"inside": "m"}}}""", "1:32: materials.m.inside: the material 'm' needs itself: m -> m; allowed: names in 'materials', which has no other")]
    [InlineData("""{"materials": {"m": {"inside": "n"}, "o": {}, "n": {"inside": "m"}}}""", "1:63: materials.n.inside: the material 'm' needs itself: m -> n -> m; allowed: o")]
    [InlineData("""{"materials": {"m": {"diffuse": {"layers": {}}}}}""", "1:44: materials.m.diffuse.layers: an object { ... } does not fit; allowed: a list of layers in brackets [ ... ]")]
    [InlineData("""{"materials": {"m": {"diffuse": {"layers": [{"texture": {"type": "grid"}, "opacity": 2}]}}}}""", "1:86: materials.m.diffuse.layers[0].opacity: the number 2 does not fit; allowed: a number at least 0 and at most 1")]
    [InlineData("""{"materials": {"m": {"diffuse": {"layers": [{"texture": {"type": "grid"}, "place": {"center": [0, 0], "size": [0, 1]}}]}}}}""", "1:111: materials.m.diffuse.layers[0].place.size: no picture is that small; allowed: a width and a height above 0")]
    [InlineData("""{"materials": {"m": {"diffuse": {"layers": [{"texture": {"type": "grid"}, "transform": {}, "place": {"center": [0, 0], "size": [1, 1]}}]}}}}""", "1:88: materials.m.diffuse.layers[0].transform: a layer has one transform; allowed: place or transform")]
    public void Read_OneMistake_IsOneLine(string json, string expected) => Assert.Equal("s.json:" + expected, SceneText.Message(json));

    private static Material Read(string material) =>
        SceneText.Read("{" + Textures + "\"objects\": [{ \"shape\": \"sphere\", \"material\": " + material + " }] }").Scene.Objects[0].Material;
}
