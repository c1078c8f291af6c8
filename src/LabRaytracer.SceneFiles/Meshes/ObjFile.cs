using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Reads triangle meshes from Wavefront OBJ files, and their materials from MTL files.</summary>
/// <remarks>
/// Read: v, vt, vn, f (also with negative indices, and polygons, which are cut into triangles), usemtl, mtllib. v points up in texture space, as in the file.
/// Names, smoothing groups, points, lines, curves and surfaces are passed over. Triangles without area are left out. Thread safe.
/// </remarks>
public static class ObjFile
{
    private const int LargeFile = 1 << 25;

    /// <summary>Reads an OBJ file. Picture files of its materials are looked for now, but decoded when a renderer needs them.</summary>
    /// <param name="path">Path of the file; MTL files and pictures are relative to its folder, and not outside it unless the options allow.</param>
    /// <param name="options">How; null for the defaults.</param>
    /// <exception cref="SceneFileException">A file cannot be read, or has mistakes: all of a file are listed.</exception>
    public static ObjScene Load(string path, SceneLoadOptions? options = null)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        string folder = Path.GetDirectoryName(Path.GetFullPath(path)) ?? "";
        return Load(path, path, new SceneFolder(folder, options ?? SceneLoadOptions.Default), useMaterials: true);
    }

    /// <summary>Reads an OBJ file of a scene.</summary>
    /// <param name="path">Path of the file.</param>
    /// <param name="shownPath">Path of the file in messages.</param>
    /// <param name="folder">The folder that files must not lie outside of.</param>
    /// <param name="useMaterials">Whether MTL files are read.</param>
    /// <exception cref="SceneFileException">A file cannot be read, or has mistakes.</exception>
    internal static ObjScene Load(string path, string shownPath, SceneFolder folder, bool useMaterials)
    {
        (ObjReader lines, IReadOnlyDictionary<string, Material> materials, SceneSourceMap map, int bytes) = ReadLines(path, shownPath, folder, useMaterials);
        if (bytes > LargeFile)
        {
            // The text is of no use any more: without it, the meshes do not come on top of it.
            GC.Collect(GC.MaxGeneration, GCCollectionMode.Aggressive, blocking: true, compacting: true);
        }

        return new ObjScene(ObjMeshes.Make(lines, materials), materials, map);
    }

    // A method of its own, not part of its caller: when it has returned, nothing holds the text.
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static (ObjReader Lines, IReadOnlyDictionary<string, Material> Materials, SceneSourceMap Map, int Bytes) ReadLines(
        string path, string shownPath, SceneFolder folder, bool useMaterials)
    {
        SceneSource source = new(shownPath, TextFiles.Read(path, folder.Options.MaxMeshBytes, "mesh"));
        ObjReader lines = ObjReader.Read(source);
        MtlLibrary library = new(source, Path.GetDirectoryName(Path.GetFullPath(path)) ?? "", folder);
        foreach ((string name, int offset) in useMaterials ? lines.Libraries : [])
        {
            library.Load(name, offset);
        }

        foreach ((_, string name, int offset) in lines.Materials)
        {
            library.CheckName(name, offset);
        }

        library.ThrowIfMistaken();
        return (lines, library.Materials, library.SourceMap, source.Bytes.Length);
    }
}
