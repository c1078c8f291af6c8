namespace LabRaytracer;

/// <summary>What an OBJ file and its MTL files hold.</summary>
/// <remarks>Immutable, thread safe.</remarks>
public sealed class ObjScene
{
    internal ObjScene(IReadOnlyList<ObjPart> parts, IReadOnlyDictionary<string, Material> materials, SceneSourceMap sourceMap)
    {
        Parts = parts;
        Materials = materials;
        SourceMap = sourceMap;
    }

    /// <summary>One mesh for each material, in the order of their first triangles; at least one.</summary>
    public IReadOnlyList<ObjPart> Parts { get; }

    /// <summary>The materials of the MTL files by name, also those without triangles.</summary>
    public IReadOnlyDictionary<string, Material> Materials { get; }

    /// <summary>Where materials and textures stand in the MTL files.</summary>
    public SceneSourceMap SourceMap { get; }
}
