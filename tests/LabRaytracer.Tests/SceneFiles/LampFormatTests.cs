namespace LabRaytracer.Tests.SceneFiles;

/// <summary>Lamps of some extent in scene files: what they mean, and one line for each mistake.</summary>
public sealed class LampFormatTests
{
    [Fact]
    public void Read_QuadLight_IsTaken()
    {
        QuadLight light = Light<QuadLight>(
            """{ "type": "quad", "corner": [1, 2, 3], "edgeU": [4, 0, 0], "edgeV": [0, 0, 5], "radiance": [6, 7, 8], "samples": 9, "sides": "both", "visible": true }""");
        Assert.Equal((new Point3D(1, 2, 3), 4 * Vector3D.UnitX, 5 * Vector3D.UnitZ), (light.Quad.Corner, light.Quad.EdgeU, light.Quad.EdgeV));
        Assert.Equal((new Intensity(6, 7, 8), 9, LightSides.Both, true), (light.Radiance, light.Samples, light.Sides, light.IsVisible));
    }

    [Fact]
    public void Read_QuadLightWithoutTheRest_HasTheDefaults()
    {
        QuadLight light = Light<QuadLight>("""{ "type": "quad", "corner": [1, 2, 3], "edgeU": [4, 0, 0], "edgeV": [0, 0, 5] }""");
        Assert.Equal((Intensity.White, 16, LightSides.Front, false), (light.Radiance, light.Samples, light.Sides, light.IsVisible));
    }

    [Fact]
    public void Read_EnvironmentLight_IsTaken()
    {
        EnvironmentLight light = Light<EnvironmentLight>(
            """{ "type": "environment", "radiance": { "texture": { "type": "grid" }, "value": 3 }, "rotation": { "rotateDegrees": 90 }, "samples": 64 }""");
        Assert.IsType<GridTexture>(light.Radiance.Texture);
        Assert.Equal((Intensity.Grey(3), 64), (light.Radiance.Value, light.Samples));
        Assert.Equal(Vector3D.UnitX, light.Rotation.WorldFromObject(Vector3D.UnitZ));
    }

    [Fact]
    public void Read_EnvironmentLightWithoutRadiance_IsTheLightOfTheBackground()
    {
        Scene scene = SceneText.Read(
            """{ "lights": [ { "type": "environment" } ], "backgroundRotation": { "rotateDegrees": 90 }, "background": { "texture": { "type": "grid" } } }""").Scene;
        EnvironmentLight light = Assert.IsType<EnvironmentLight>(scene.Lights[0]);
        Assert.Same(scene.Background, light.Radiance);
        Assert.Same(scene.BackgroundRotation, light.Rotation);
        Assert.Equal((32, Vector3D.UnitX), (light.Samples, scene.BackgroundRotation.WorldFromObject(Vector3D.UnitZ)));
    }

    [Theory]
    [InlineData("""{"backgroundRotation": {"scale": 2}}""", "1:24: backgroundRotation: the transform does more than rotate; allowed: steps with rotateDegrees")]
    [InlineData("""{"backgroundRotation": 90}""", "1:24: backgroundRotation: the number 90 does not fit; allowed: a step { translate | scale | rotateDegrees, axis | matrix } or a list of steps")]
    [InlineData("""{"lights": [{"type": "environment", "rotation": {"translate": [1, 0, 0]}}]}""", "1:49: lights[0].rotation: the transform does more than rotate; allowed: steps with rotateDegrees")]
    [InlineData("""{"lights": [{"type": "environment", "radiance": "sky"}]}""", "1:49: lights[0].radiance: there is no texture 'sky'; allowed: names in 'textures', which is empty")]
    [InlineData("""{"lights": [{"type": "quad", "corner": [0, 1, 0], "edgeU": [1, 0, 0], "edgeV": [2, 0, 0]}]}""", "1:60: lights[0].edgeU: the edges span no area; allowed: edges that are not parallel")]
    [InlineData("""{"lights": [{"type": "quad", "corner": [0, 1, 0], "edgeU": [1, 0, 0]}]}""", "1:13: lights[0]: the key 'edgeV' is missing; allowed: three numbers [x, y, z], not all 0")]
    [InlineData("""{"lights": [{"type": "quad", "corner": [0, 1, 0], "edgeU": [1, 0, 0], "edgeV": [0, 0, 1], "samples": 0}]}""", "1:102: lights[0].samples: the number 0 does not fit; allowed: a whole number from 1 to 4096")]
    [InlineData("""{"lights": [{"type": "quad", "corner": [0, 1, 0], "edgeU": [1, 0, 0], "edgeV": [0, 0, 1], "sides": "back"}]}""", "1:100: lights[0].sides: unknown word 'back'; allowed: front, both")]
    [InlineData("""{"lights": [{"type": "quad", "corner": [0, 1, 0], "edgeU": [1, 0, 0], "edgeV": [0, 0, 1], "radiance": -1}]}""", "1:103: lights[0].radiance: the number -1 does not fit; allowed: a number at least 0 and at most 1000000000")]
    public void Read_OneMistake_IsOneLine(string json, string expected) => Assert.Equal("s.json:" + expected, SceneText.Message(json));

    private static T Light<T>(string json)
        where T : Light => Assert.IsType<T>(SceneText.Read($$"""{ "lights": [ {{json}} ] }""").Scene.Lights[0]);
}
