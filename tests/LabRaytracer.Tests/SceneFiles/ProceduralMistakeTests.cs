namespace LabRaytracer.Tests.SceneFiles;

/// <summary>Procedural textures, mappings and curved shapes of scene files: what they become, and what is said about mistakes.</summary>
public sealed class ProceduralMistakeTests
{
    [Theory]
    [InlineData("""{"textures": {"a": {"type": "nois"}}}""", "1:29: textures.a.type: unknown type 'nois', did you mean 'noise'; allowed: image, constant, checker, grid, noise, worley, marble, wood, brick, gradient, multiply, mix, select, layers, ramp, transformed, triplanar")]
    [InlineData("""{"textures": {"a": {"type": "noise", "octaves": 17}}}""", "1:49: textures.a.octaves: the number 17 does not fit; allowed: a whole number from 1 to 16")]
    [InlineData("""{"textures": {"a": {"type": "noise", "noise": "perlin"}}}""", "1:47: textures.a.noise: unknown word 'perlin'; allowed: gradient, value, cubic, simplex")]
    [InlineData("""{"textures": {"a": {"type": "noise", "ramp": []}}}""", "1:46: textures.a.ramp: a list of 0; allowed: one stop or more")]
    [InlineData("""{"textures": {"a": {"type": "noise", "ramp": [{"color": 1}]}}}""", "1:47: textures.a.ramp[0]: the key 'at' is missing; allowed: a finite number")]
    [InlineData("""{"textures": {"a": {"type": "worley", "metric": "euclid"}}}""", "1:49: textures.a.metric: unknown word 'euclid'; allowed: euclidean, manhattan, chebyshev")]
    [InlineData("""{"textures": {"a": {"type": "wood", "rings": 0}}}""", "1:46: textures.a.rings: the number 0 does not fit; allowed: a number above 0")]
    [InlineData("""{"textures": {"a": {"type": "brick", "mortar": 2}}}""", "1:48: textures.a.mortar: the number 2 does not fit; allowed: a number at least 0 and at most 1")]
    [InlineData("""{"textures": {"a": {"type": "marble", "filterWidth": -1}}}""", "1:54: textures.a.filterWidth: the number -1 does not fit; allowed: a number at least 0 and at most 16")]
    [InlineData("""{"textures": {"a": {"type": "multiply", "first": "b", "second": {"type": "wood"}}}}""", "1:50: textures.a.first: there is no texture 'b'; allowed: names in 'textures', which has no other")]
    [InlineData("""{"textures": {"a": {"type": "triplanar", "texture": "b"}, "b": {"type": "triplanar", "texture": "c"}, "c": {"type": "triplanar", "texture": "b"}}}""", "1:141: textures.c.texture: the texture 'b' needs itself: b -> c -> b; allowed: names in 'textures', which has no other")]
    [InlineData("""{"textures": {"a": {"type": "mix", "first": {"type": "wood"}, "second": {"type": "wood"}, "weight": 2}}}""", "1:101: textures.a.weight: the number 2 does not fit; allowed: a number at least 0 and at most 1")]
    [InlineData("""{"textures": {"a": {"type": "triplanar"}}}""", "1:20: textures.a: the key 'texture' is missing; allowed: the name of a texture, or a texture { \"type\": ... }")]
    [InlineData("""{"objects": [{"shape": "torus", "ringRadius": 1, "tubeRadius": 1}]}""", "1:64: objects[0].tubeRadius: the tube is not thinner than the ring; allowed: a tubeRadius below the ringRadius")]
    [InlineData("""{"objects": [{"shape": "cone", "caps": "both"}]}""", "1:40: objects[0].caps: unknown word 'both'; allowed: open, closed")]
    [InlineData("""{"materials": {"m": {"diffuse": {"mapping": {"type": "projector", "eye": [0, 1, 0]}}}}}""", "1:45: materials.m.diffuse.mapping: the projector has no line of sight, or its up direction lies along it; allowed: a target other than the eye, and an up direction beside the line between them")]
    [InlineData("""{"materials": {"m": {"diffuse": {"mapping": {"type": "cube"}}}}}""", "1:54: materials.m.diffuse.mapping.type: unknown type 'cube'; allowed: lightProbe, torus, projector")]
    [InlineData("""{"materials": {"m": {"diffuse": {"mapping": "conic"}}}}""", "1:45: materials.m.diffuse.mapping: unknown word 'conic'; allowed: rectangular, cylindrical, spherical, mesh, disk, box, hemispherical, equalArea, lightProbe, torus, cone")]
    public void Read_Mistake_IsNamedWithItsPlace(string text, string expected) => Assert.Equal("s.json:" + expected, SceneText.Message(text));

    /// <summary>Textures may stand below those that need them, as members of an object have no order.</summary>
    [Theory]
    [InlineData(3)]
    [InlineData(99)]
    public void Read_TexturesThatStandBelow_AreFound(int count)
    {
        LoadedScene loaded = SceneText.Read($$"""{ "textures": { {{Chain(count)}}, "t{{count}}": { "type": "constant", "color": 0.5 } }, "background": "t0" }""");
        Assert.Equal(Enumerable.Range(0, count + 1).Select(i => $"t{i}"), loaded.Textures.Keys);
        Assert.Equal(0.5f, loaded.Scene.Background.Texture!.Sample(TextureLookup.At(0.5, 0.5)).R);
    }

    [Fact]
    public void Read_TooManyTexturesThatStandBelow_AreRefused()
    {
        string message = SceneText.Message($$"""{"textures": { {{Chain(101)}}, "t101": {"type": "wood"} } }""");
        Assert.EndsWith(": textures.t99.texture: too many names need each other; allowed: 100 in a row, more where each stands above the one that needs it", message);
    }

    /// <summary>Textures t0, t1, ... each of which needs the next one.</summary>
    private static string Chain(int count) => string.Join(", ", Enumerable.Range(0, count).Select(i => $$"""  "t{{i}}": { "type": "transformed", "texture": "t{{i + 1}}" }  """));

    [Fact]
    public void Read_Textures_AreWhatTheFileSays()
    {
        Scene scene = SceneText.Read("""
            {
              "textures": {
                "n": { "type": "noise", "noise": "cubic", "sum": "turbulence", "octaves": 3, "lacunarity": 2.5, "gain": 0.4, "seed": -4, "frequency": 7, "space": "uv", "filterWidth": 0,
                       "ramp": [{ "at": 1, "color": [1, 0, 0] }, { "at": -1, "color": 0.25 }] },
                "all": { "type": "layers", "ground": "n", "layers": [{ "texture": { "type": "transformed", "texture": "n", "transform": { "scale": 2 }, "frame": "world", "uv": { "scale": 3 } } }] }
              },
              "objects": [
                { "shape": "torus", "center": [1, 2, 3], "ringRadius": 2, "tubeRadius": 0.5, "material": { "diffuse": "n" } },
                { "shape": "cone", "radius": 3, "height": 4, "caps": "open", "material": { "diffuse": { "texture": "all", "mapping": { "type": "torus", "ringRadius": 2 } } } }
              ]
            }
            """).Scene;
        NoiseTexture noise = Assert.IsType<NoiseTexture>(scene.Objects[0].Material.Diffuse.Texture);
        Assert.Equal((NoiseKind.Cubic, NoiseSum.Turbulence, 3, 2.5, 0.4, -4), (noise.Noise.Kind, noise.Noise.Sum, noise.Noise.Octaves, noise.Noise.Lacunarity, noise.Noise.Gain, noise.Noise.Seed));
        Assert.Equal((7, PatternSpace.Uv, 0), (noise.Frequency, noise.Space, noise.FilterWidth));
        Assert.Equal([new ColorStop(-1, Intensity.Grey(0.25f)), new ColorStop(1, new Intensity(1, 0, 0))], noise.Ramp.Stops);
        Torus torus = Assert.IsType<Torus>(scene.Objects[0].Shape);
        Assert.Equal((new Point3D(1, 2, 3), 2, 0.5), (torus.Center, torus.RingRadius, torus.TubeRadius));
        Cone cone = Assert.IsType<Cone>(scene.Objects[1].Shape);
        Assert.Equal((3, 4, ConeCaps.Open), (cone.Radius, cone.Height, cone.Caps));
        TextureSlot slot = scene.Objects[1].Material.Diffuse;
        Assert.Equal(2, Assert.IsType<TorusMapping>(slot.Mapping).RingRadius);
        LayeredTexture layers = Assert.IsType<LayeredTexture>(slot.Texture);
        Assert.Same(noise, layers.Ground);
        TransformedTexture moved = Assert.IsType<TransformedTexture>(Assert.Single(layers.Layers).Texture);
        Assert.Equal((TextureFrame.World, new TextureCoordinate(3, 6)), (moved.Frame, moved.Uv.Apply(new TextureCoordinate(1, 2))));
    }
}
