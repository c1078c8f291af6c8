namespace LabRaytracer.Tests.SceneFiles;

/// <summary>Cameras with a lens and fisheyes in scene files.</summary>
public sealed class CameraFormatTests
{
    [Fact]
    public void Read_ThinLens_IsTaken()
    {
        ThinLensCamera camera = Camera<ThinLensCamera>(
            """{ "type": "thinLens", "eye": [0, 0, 5], "target": [0, 0, 1], "fieldOfViewDegrees": 30, "lensRadius": 0.2, "focusDistance": 3 }""");
        Assert.Equal((0.2, 3.0, 30.0), (camera.LensRadius, camera.FocusDistance, camera.Pinhole.FieldOfViewDegrees));
        Assert.Equal(4, Camera<ThinLensCamera>("""{ "type": "thinLens", "eye": [0, 0, 5], "target": [0, 0, 1], "lensRadius": 0 }""").FocusDistance);
    }

    [Fact]
    public void Read_Fisheye_IsTaken()
    {
        FisheyeCamera camera = Camera<FisheyeCamera>("""{ "type": "fisheye", "eye": [0, 0, 5], "fieldOfViewDegrees": 220 }""");
        Assert.Equal((220.0, Point3D.Origin), (camera.FieldOfViewDegrees, camera.Target));
        Assert.Equal(180, Camera<FisheyeCamera>("""{ "type": "fisheye", "eye": [0, 0, 5] }""").FieldOfViewDegrees);
    }

    [Theory]
    [InlineData("""{"camera": {"type": "thinLens", "eye": [0, 0, 5]}}""", "1:12: camera: the key 'lensRadius' is missing; allowed: a number at least 0")]
    [InlineData("""{"camera": {"type": "thinLens", "eye": [0, 0, 5], "lensRadius": -1}}""", "1:65: camera.lensRadius: the number -1 does not fit; allowed: a number at least 0")]
    [InlineData("""{"camera": {"type": "thinLens", "eye": [0, 0, 5], "lensRadius": 1, "focusDistance": 0}}""", "1:85: camera.focusDistance: the number 0 does not fit; allowed: a number above 0")]
    [InlineData("""{"camera": {"type": "thinLens", "eye": [0, 0, 0], "lensRadius": 1}}""", "1:12: camera: the target is where the camera stands; allowed: any other point")]
    [InlineData("""{"camera": {"type": "fisheye", "eye": [0, 0, 5], "fieldOfViewDegrees": 400}}""", "1:72: camera.fieldOfViewDegrees: the number 400 does not fit; allowed: a number above 0 and at most 360")]
    public void Read_OneMistake_IsOneLine(string json, string expected) => Assert.Equal("s.json:" + expected, SceneText.Message(json));

    private static T Camera<T>(string json)
        where T : Camera => Assert.IsType<T>(SceneText.Read($$"""{ "camera": {{json}} }""").Scene.Camera);
}
