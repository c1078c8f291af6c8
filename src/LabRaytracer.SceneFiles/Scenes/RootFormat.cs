namespace LabRaytracer;

/// <summary>The whole scene file.</summary>
internal static class RootFormat
{
    private static readonly Key<string> s_schema = Key.Optional("$schema", TextFormat.Instance, "Path of scene.schema.json: editors then complete keys and check values.");

    private static readonly Key<RenderOptions> s_render = Key.Optional("render", SettingsFormats.Render, "How the scene is rendered.");

    private static readonly Key<SceneOutput> s_output = Key.Optional("output", SettingsFormats.Output, "How the picture is written.");

    private static readonly Key<Camera> s_camera = Key.Optional("camera", CameraFormats.Any, "The camera. Default: perspective, from [0, 0, 5] to the origin, 40 degrees.");

    private static readonly Key<TextureSlot> s_background = Key.Optional(
        "background", new KeptFormat<TextureSlot>(SlotFormats.Color, (reading, slot) => reading.Background = slot), Intensity.Black, "What rays see that hit nothing. A texture is mapped by their direction; the default mapping is spherical.");

    private static readonly Key<Transform> s_backgroundRotation = Key.Optional(
        "backgroundRotation",
        new KeptFormat<Transform>(TransformFormats.Any, (reading, rotation) => reading.BackgroundRotation = rotation),
        "Turns the background: steps with rotateDegrees. Default: none.");

    private static readonly Key<NamedThings<ITexture>> s_textures = Key.Optional("textures", TextureFormats.Map, "Textures by names of your choice.");

    private static readonly Key<NamedThings<Material>> s_materials = Key.Optional("materials", MaterialFormats.Map, "Materials by names of your choice.");

    private static readonly Key<IReadOnlyList<SceneObject[]>> s_objects = Key.Optional(
        "objects", new ListFormat<SceneObject[]>(ObjectFormats.Any, "objects"), "The objects.");

    private static readonly Key<IReadOnlyList<Light>> s_lights = Key.Optional("lights", new ListFormat<Light>(LightFormats.Any, "lights"), "The lamps.");

    /// <summary>The whole file. Keys are read in this order: textures before the materials that use them, materials before objects.</summary>
    public static ObjectFormat<LoadedScene> Scene { get; } = new(
        "scene",
        "A scene of LabRaytracer. Lengths are in units of your choice, +Y is up, angles are in degrees, colours are linear unless written \"#rrggbb\".",
        [s_schema, s_render, s_output, s_camera, s_textures, s_materials, s_background, s_backgroundRotation, s_objects, s_lights],
        Build);

    private static LoadedScene Build(Fields fields)
    {
        Scene scene = new() { Background = fields.Get(s_background) };
        if (fields.Find(s_camera) is { } camera)
        {
            scene.Camera = camera;
        }

        if (fields.Find(s_backgroundRotation) is { } rotation)
        {
            fields.Make(s_backgroundRotation, () => scene.BackgroundRotation = rotation, TransformFormats.MoreThanRotation, TransformFormats.Rotations);
        }

        foreach (SceneObject placed in (fields.Find(s_objects) ?? []).SelectMany(placed => placed))
        {
            scene.Objects.Add(placed);
        }

        foreach (Light light in fields.Find(s_lights) ?? [])
        {
            scene.Lights.Add(light);
        }

        return new LoadedScene(scene, fields.Find(s_render) ?? new RenderOptions(), fields.Find(s_output) ?? SceneOutput.Default, new Dictionary<string, ITexture>(fields.Reading.Textures.Good, StringComparer.Ordinal), fields.Reading.SourceMap);
    }
}
