namespace LabRaytracer;

/// <summary>Meshes of scene files: OBJ files.</summary>
internal static class MeshFormats
{
    /// <summary>The OBJ file.</summary>
    public static Key<NamedFile> File { get; } = Key.Required("file", new FileFormat("an OBJ mesh"), "Path of an OBJ file, relative to the folder of this file.");

    /// <summary>The meshes and materials of the file; a file is read once, however many objects show it.</summary>
    /// <param name="fields">The object of the scene file.</param>
    /// <param name="useMaterials">False where the scene gives a material: then MTL files are not read, nor missed.</param>
    /// <returns>Null after mistakes, which are noted.</returns>
    public static ObjScene? Load(Fields fields, bool useMaterials)
    {
        SceneReading reading = fields.Reading;
        (string path, string shownPath, _) = fields.Get(File);
        if (reading.Folder.Loaded.TryGetValue((path, useMaterials), out ObjScene? known))
        {
            return known;
        }

        try
        {
            known = ObjFile.Load(path, shownPath, reading.Folder, useMaterials);
            reading.SourceMap.Add(known.SourceMap);
        }
        catch (SceneFileException failure)
        {
            reading.Mistakes(failure.Errors);
        }

        reading.Folder.Loaded.Add((path, useMaterials), known);
        return known;
    }
}
