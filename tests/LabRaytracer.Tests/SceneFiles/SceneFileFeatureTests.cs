namespace LabRaytracer.Tests.SceneFiles;

/// <summary>What right scene files mean.</summary>
public sealed class SceneFileFeatureTests
{
    /// <summary>A scene with every key that needs no file.</summary>
    internal const string EveryKey = """
        // comments and trailing commas are allowed
        {
          "$schema": "scene.schema.json",
          "render": { "width": 320, "height": 200.0, "samples": 4, "pattern": "jittered", "pixelFilter": "mitchell", "errorBudget": 0.02, "maxSamples": 64, "edgeSamples": 32, "maxDepth": 7, "seed": -3, "precision": "single" },
          "output": { "file": "earth.png", "encoding": "linear", "exposureStops": -1.5, "toneMapping": "reinhard", "bitDepth": 16 },
          "camera": { "type": "perspective", "eye": [0, 1, 4.5], "target": [0, 1, 0], "up": [0, 2, 0], "fieldOfViewDegrees": 55 },
          "background": { "texture": { "type": "constant", "color": [0.1, 0.2, 0.3] }, "value": 0.5 },
          /* textures by name */
          "textures": {
            "check": { "type": "checker", "even": "#ff8000", "odd": 0.25, "columns": 3, "rows": 4, "space": "local", "lineWidth": 0.1, "line": [0, 0, 2] },
            "grid": { "type": "grid", "columns": 12, "rows": 6, "lineWidth": 0.02 },
          },
          "materials": {
            "globe": {
              "ambient": 0.1,
              "diffuse": {
                "texture": "check", "value": [1, 0.5, 0.25], "amount": 0.5, "blend": "add", "mapping": "cylindrical",
                "transform": { "offset": [0.5, 0], "scale": 2, "rotateDegrees": 90, "center": [0.5, 0.5] },
              },
              "specular": "grid",
              "shininess": { "texture": "grid", "channel": "red", "amount": 0.25, "blend": "replace", "mapping": "box" },
              "reflection": [0.1, 0.2, 0.3],
              "transparency": "#ffffff",
              "indexOfRefraction": 1.5,
              "fresnel": "schlick",
              "emission": 0,
            },
          },
          "objects": [
            { "name": "ball", "shape": "sphere", "center": [1, 2, 3], "radius": 0.5, "material": "globe", "castsShadows": false,
              "transform": [ { "rotateDegrees": 90 }, { "scale": [1, 2, 1] }, { "translate": [0, 0, 5] }, { "matrix": [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0] } ] },
            { "shape": "plane", "point": [0, -1, 0], "normal": [0, 1, 0], "material": { "diffuse": 0.5 }, "transform": { "rotateDegrees": 45, "axis": [1, 0, 0] } },
            { "shape": "quad", "corner": [0, 0, 0], "edgeU": [1, 0, 0], "edgeV": [0, 1, 0] },
            { "shape": "cylinder", "center": [0, 1, 0], "radius": 2, "height": 3 },
            { "shape": "disk", "center": [0, 1, 0], "normal": [0, 0, 1], "radius": 2 },
            { "shape": "box", "corner": [0, 0, 0], "opposite": [1, 2, 3] },
            { "shape": "triangle", "a": [0, 0, 0], "b": [1, 0, 0], "c": [0, 1, 0], "normals": [[0, 0, 1], [0, 0, 2], [0, 1, 1]], "uvs": [[0, 0], [1, 0], [1, 1]] },
          ],
          "lights": [
            { "type": "point", "position": [4, 6, 5], "intensity": [1, 2, 3], "attenuation": [1, 0.5, 0.25] },
            { "type": "directional", "direction": [0, -2, 0] },
            { "type": "spot", "position": [0, 5, 0], "target": [0, 0, 0], "outerDegrees": 40, "innerDegrees": 20, "intensity": 2 },
            { "type": "ambient", "intensity": 0.1 },
          ],
        }
        """;

    private static readonly LoadedScene s_all = SceneText.Read(EveryKey);

    [Fact]
    public void Read_EmptyObject_IsTheDefaultScene()
    {
        LoadedScene loaded = SceneText.Read("{}");
        Assert.Empty(loaded.Scene.Objects);
        Assert.Equal(Intensity.Black, loaded.Scene.Background.Value);
        Assert.Equal((1280, 720, 1, 5), (loaded.RenderOptions.Width, loaded.RenderOptions.Height, loaded.RenderOptions.Samples, loaded.RenderOptions.MaxDepth));
        Assert.Null(loaded.Output.FileName);
        Assert.Equal(8, loaded.Output.Picture.BitDepth);
    }

    [Fact]
    public void Read_Settings_AreTaken()
    {
        RenderOptions render = s_all.RenderOptions;
        Assert.Equal((320, 200, 4, 7, -3), (render.Width, render.Height, render.Samples, render.MaxDepth, render.Seed));
        Assert.Equal((SamplePattern.Jittered, Precision.Single), (render.Pattern, render.Precision));
        Assert.Equal((PixelFilter.Mitchell, 0.02, 64, 32), (render.PixelFilter, render.ErrorBudget, render.MaxSamples, render.EdgeSamples));
        PictureSaveOptions picture = s_all.Output.Picture;
        Assert.Equal("earth.png", s_all.Output.FileName);
        Assert.Equal((16, -1.5, ToneOperator.Reinhard), (picture.BitDepth, picture.ToneMapping.Exposure, picture.ToneMapping.Operator));
        Assert.True(picture.Encoding.IsLinear);
    }

    [Fact]
    public void Read_Camera_IsTaken()
    {
        PerspectiveCamera camera = Assert.IsType<PerspectiveCamera>(s_all.Scene.Camera);
        Assert.Equal((new Point3D(0, 1, 4.5), new Point3D(0, 1, 0), 55.0), (camera.Eye, camera.Target, camera.FieldOfViewDegrees));
        OrthographicCamera parallel = Assert.IsType<OrthographicCamera>(
            SceneText.Read("""{"camera": {"type": "orthographic", "eye": [0, 0, 3], "height": 2.5}}""").Scene.Camera);
        Assert.Equal((2.5, Point3D.Origin), (parallel.Height, parallel.Target));
        Assert.Equal(new Point3D(1, 2, 3), Assert.IsType<SphericalCamera>(
            SceneText.Read("""{"camera": {"eye": [1, 2, 3], "type": "spherical"}}""").Scene.Camera).Eye);
    }

    [Fact]
    public void Read_Textures_AreTaken()
    {
        Material globe = s_all.Scene.Objects[0].Material;
        CheckerTexture check = Assert.IsType<CheckerTexture>(globe.Diffuse.Texture);
        Assert.Equal(new Intensity(1, ColorEncoding.LinearFromSrgb8(128), 0), check.Even);
        Assert.Equal((Intensity.Grey(0.25f), new Intensity(0, 0, 2)), (check.Odd, check.Line));
        Assert.Equal((3.0, 4.0, CheckerSpace.Local, 0.1), (check.Columns, check.Rows, check.Space, check.LineWidth));
        GridTexture grid = Assert.IsType<GridTexture>(globe.Specular.Texture);
        Assert.Equal((12, 6, 0.02), (grid.Columns, grid.Rows, grid.LineWidth));
        Assert.Same(grid, globe.Shininess.Texture);
        Assert.Equal(new Intensity(0.1f, 0.2f, 0.3f), Assert.IsType<ConstantTexture>(s_all.Scene.Background.Texture).Color);
    }

    [Fact]
    public void Read_Material_IsTaken()
    {
        Material globe = s_all.Scene.Objects[0].Material;
        Assert.Equal("globe", globe.Name);
        Assert.Equal(Intensity.Grey(0.1f), globe.Ambient!.Value);
        Assert.Equal((new Intensity(1, 0.5f, 0.25f), 0.5f, BlendMode.Add), (globe.Diffuse.Value, globe.Diffuse.Amount, globe.Diffuse.Blend));
        Assert.IsType<CylindricalMapping>(globe.Diffuse.Mapping);
        Assert.Equal(new UvTransform(new TextureCoordinate(0.5, 0), 90, new TextureCoordinate(2, 2), new TextureCoordinate(0.5, 0.5)), globe.Diffuse.Transform);
        Assert.Equal((50f, TextureChannel.Red, 0.25f, BlendMode.Replace), (globe.Shininess.Value, globe.Shininess.Channel, globe.Shininess.Amount, globe.Shininess.Blend));
        Assert.Equal((new Intensity(0.1f, 0.2f, 0.3f), Intensity.White, 1.5f), (globe.Reflection.Value, globe.Transparency.Value, globe.IndexOfRefraction.Value));
        Assert.Equal((FresnelModel.Schlick, Intensity.Black), (globe.Fresnel, globe.Emission.Value));
    }

    [Fact]
    public void Read_Objects_AreTaken()
    {
        IList<SceneObject> objects = s_all.Scene.Objects;
        Sphere ball = Assert.IsType<Sphere>(objects[0].Shape);
        Assert.Equal((new Point3D(1, 2, 3), 0.5, "ball", false), (ball.Center, ball.Radius, objects[0].Name, objects[0].CastsShadows));
        Assert.Equal(new Point3D(0, -1, 0), Assert.IsType<InfinitePlane>(objects[1].Shape).Point);
        Assert.IsType<Quad>(objects[2].Shape);
        Assert.IsType<Cylinder>(objects[3].Shape);
        Assert.IsType<Disk>(objects[4].Shape);
        Assert.IsType<Box>(objects[5].Shape);
        Assert.Equal(new TextureCoordinate(1, 1), Assert.IsType<Triangle>(objects[6].Shape).VertexCoordinates[2]);
        Assert.True(objects[6].CastsShadows);
    }

    [Fact]
    public void Read_TransformSteps_ApplyFromFirstToLast()
    {
        // (0, 0, 1) turned by 90 degrees about +Y is (1, 0, 0); scaled (1, 0, 0); moved (1, 0, 5); the matrix adds 1 to x.
        Assert.Equal(new Point3D(2, 0, 5), s_all.Scene.Objects[0].Transform.WorldFromObject(new Point3D(0, 0, 1)));
    }

    [Fact]
    public void Read_Lights_AreTaken()
    {
        IList<Light> lights = s_all.Scene.Lights;
        PointLight point = Assert.IsType<PointLight>(lights[0]);
        Assert.Equal((new Point3D(4, 6, 5), new Intensity(1, 2, 3), 0.5, 0.25), (point.Position, point.Intensity, point.Attenuation.Linear, point.Attenuation.Quadratic));
        Assert.Equal(new Vector3D(0, -1, 0), Assert.IsType<DirectionalLight>(lights[1]).Direction);
        SpotLight spot = Assert.IsType<SpotLight>(lights[2]);
        Assert.Equal((40.0, 20.0, Intensity.Grey(2)), (spot.OuterDegrees, spot.InnerDegrees, spot.Intensity));
        Assert.Equal(Intensity.Grey(0.1f), Assert.IsType<AmbientLight>(lights[3]).Intensity);
    }

    [Fact]
    public void Read_ByteOrderMark_IsAccepted() => Assert.Equal(7, SceneText.Read("\uFEFF" + EveryKey).Scene.Objects.Count);

    [Fact]
    public void Load_Picture_IsFoundBesideTheSceneAndDecodedOnce()
    {
        using TestFolder folder = new();
        folder.Write("textures/red.ppm", "P3 1 1 255 255 0 0");
        string path = folder.Write("scene.json", """
            {
              "textures": {
                "a": { "type": "image", "file": "textures/red.ppm", "filter": "nearest", "texels": "lab", "wrapU": "mirror", "wrapV": "border", "borderColor": [0.25, 0.5, 2], "colorSpace": "linear" },
                "b": { "type": "image", "file": "./textures/red.ppm" },
              },
              "background": "a",
              "objects": [ { "shape": "sphere", "material": { "diffuse": "b" } } ]
            }
            """);
        LoadedScene loaded = SceneFile.Load(path);
        Texture a = Assert.IsType<Texture>(loaded.Scene.Background.Texture);
        Texture b = Assert.IsType<Texture>(loaded.Scene.Objects[0].Material.Diffuse.Texture);
        Assert.Equal((TextureFilter.Nearest, TexelConvention.Lab, TextureWrap.Mirror, TextureWrap.Border, new Intensity(0.25f, 0.5f, 2), ColorSpace.Linear),
            (a.Sampling.Filter, a.Sampling.Texels, a.Sampling.WrapU!.Value, a.Sampling.WrapV!.Value, a.Sampling.BorderColor, a.Sampling.ColorSpace));
        Assert.Equal((TextureFilter.Ewa, new Intensity(0.25f, 0.5f, 2)), (a.Sampling.With(TextureFilter.Ewa).Filter, a.Sampling.With(TextureFilter.Ewa).BorderColor));
        Assert.Equal((TextureFilter.Bilinear, null), (b.Sampling.Filter, b.Sampling.WrapU));
        Assert.Equal(a.Path, b.Path);
        Assert.Equal(new Intensity(1, 0, 0), b.ColorMap[0, 0]);
    }

    [Fact]
    public void Explain_PictureThatCannotBeDecoded_NamesItsPlaceInTheScene()
    {
        using TestFolder folder = new();
        folder.Write("broken.png", "not a picture");
        string path = folder.Write("scene.json", "{\n  \"background\": { \"texture\": { \"type\": \"image\", \"file\": \"broken.png\" } } }");
        LoadedScene loaded = SceneFile.Load(path);
        Texture texture = Assert.IsType<Texture>(loaded.Scene.Background.Texture);
        PictureFormatException failure = Assert.Throws<PictureFormatException>(() => texture.Width);
        SceneFileError error = loaded.SourceMap.Explain(texture, failure).Errors.Single();
        Assert.Equal((path, 2, 57), (error.File, error.Line, error.Column));
        Assert.True(loaded.SourceMap.TryLocate(texture, out SceneLocation location));
        Assert.Equal($"{path}:2:57", location.ToString());
    }

    [Fact]
    public void Load_OutsidePath_IsTakenWhereOptionsAllow()
    {
        using TestFolder folder = new();
        folder.Write("red.ppm", "P3 1 1 255 255 0 0");
        string path = folder.Write("scenes/scene.json", """{ "background": { "texture": { "type": "image", "file": "../red.ppm" } } }""");
        Assert.Throws<SceneFileException>(() => SceneFile.Load(path));
        Assert.NotNull(SceneFile.Load(path, new SceneLoadOptions { AllowOutsidePaths = true }).Scene.Background.Texture);
    }
}
