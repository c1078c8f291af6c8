namespace LabRaytracer;

/// <summary>Objects of scene files: a shape with its material and place.</summary>
internal static class ObjectFormats
{
    private static readonly Material s_white = new();

    private static readonly Key<string> s_name = Key.Optional("name", TextFormat.Instance, "", "Name for messages and statistics.");

    private static readonly Key<Material> s_material = Key.Optional("material", MaterialFormats.Any, "Name of a material, or a material in place. Default: matte white.");

    private static readonly Key<Material> s_meshMaterial = Key.Optional(
        "material", MaterialFormats.Any, "Name of a material, or a material in place, for the whole mesh. Default: those of the MTL files.");

    private static readonly Key<Transform> s_transform = Key.Optional(
        "transform", TransformFormats.Any, "From object space to world space: steps, applied from first to last. Default: none.");

    private static readonly Key<bool> s_castsShadows = Key.Optional("castsShadows", SwitchFormat.Instance, true, "Whether the object blocks light.");

    /// <summary>An object, told by its shape.</summary>
    public static VariantFormat<SceneObject[]> Any { get; } = new(
        "shape",
        "A shape with a material at a place in the world.",
        [
            .. ShapeFormats.All.Select(Single),
            new("mesh", "Triangles of an OBJ file, with the materials of its MTL files.", [s_name, MeshFormats.File, s_meshMaterial, s_transform, s_castsShadows], Mesh, ("shape", "mesh")),
        ]);

    private static ObjectFormat<SceneObject[]> Single(ShapeFormat shape) => new(
        shape.Word,
        shape.Description,
        [s_name, .. shape.Keys, s_material, s_transform, s_castsShadows],
        fields => shape.Make(fields) is { } made ? [Place(fields, made, fields.Find(s_material) ?? s_white)] : null,
        ("shape", shape.Word));

    // An object for each material of the file.
    private static SceneObject[]? Mesh(Fields fields)
    {
        Material? material = fields.Find(s_meshMaterial);
        return MeshFormats.Load(fields, useMaterials: material is null) is { } mesh
            ? [.. mesh.Parts.Select(part => Place(fields, part.Mesh, material ?? part.Material ?? s_white))]
            : null;
    }

    private static SceneObject Place(Fields fields, Shape shape, Material material)
    {
        SceneObject placed = new(shape, material, fields.Find(s_transform))
        {
            Name = fields.Get(s_name), CastsShadows = fields.Get(s_castsShadows),
        };
        fields.Reading.Note(placed, fields.Node);
        return placed;
    }
}
