using System.Globalization;

namespace LabRaytracer.Benchmarks;

/// <summary>Writes the scenes s1 to s5 in POV-Ray's language: spheres, planes and meshes with pictures, point lights.</summary>
/// <remarks>
/// The camera's "right" points to -x, which makes POV-Ray's world right-handed. POV-Ray's pictures are turned by matrices so that they lie where the sheet's mappings put them.
/// </remarks>
internal sealed class PovScene(TextWriter text, string folder, string? interpolate)
{
    // A sphere's picture: POV-Ray measures the azimuth from x towards z, the sheet from z towards x.
    private const string SwapXZ = "matrix <0,0,1, 0,1,0, 1,0,0, 0,0,0>";

    // A plane's picture: u = (z + 1) / 2, v = (x + 1) / 2.
    private const string FloorFrame = "matrix <0,0,2, 2,0,0, 0,2,0, -1,0,-1>";

    /// <summary>Writes a scene file and what it includes.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="folder">Folder of the file.</param>
    /// <param name="name">Its name without extension.</param>
    /// <param name="width">Width of the picture, pixels.</param>
    /// <param name="height">Height of the picture, pixels.</param>
    /// <param name="interpolate">Interpolation of pictures; null: as the textures' filters ask.</param>
    /// <returns>Path of the file.</returns>
    public static string Write(LoadedScene scene, string folder, string name, int width, int height, string? interpolate = null)
    {
        string path = Path.Combine(folder, $"{name}.pov");
        using StreamWriter text = new(path);
        new PovScene(text, folder, interpolate).Write(scene.Scene, name, (double)width / height);
        return path;
    }

    /// <summary>Tells whether a scene's textures are pictures, which POV-Ray can show too.</summary>
    public static bool CanWrite(Scene scene) => scene.Objects.All(item => (item.Material.Diffuse.Texture ?? item.Material.Ambient?.Texture) is Texture);

    private void Write(Scene scene, string name, double aspect)
    {
        PerspectiveCamera camera = (PerspectiveCamera)scene.Camera;
        double across = 2 * Math.Atan(Math.Tan(camera.FieldOfViewDegrees * Math.PI / 360) * aspect) * 180 / Math.PI;
        Line($"#version 3.7;");
        Line($"global_settings {{ assumed_gamma 1.0 max_trace_level 6 ambient_light rgb <1,1,1> }}");
        Line($"camera {{ perspective location {Of(camera.Eye)} up y right -x*{aspect} angle {across} look_at {Of(camera.Target)} }}");
        Line($"background {{ rgb {Of(scene.Background.Value)} }}");
        foreach (PointLight light in scene.Lights.OfType<PointLight>())
        {
            Line($"light_source {{ {Of(light.Position)} rgb {Of(light.Intensity)} }}");
        }

        foreach ((SceneObject item, int number) in scene.Objects.Select((item, number) => (item, number)))
        {
            Write(item, $"{name}-{number}.inc");
        }
    }

    private void Write(SceneObject item, string includeName)
    {
        switch (item.Shape)
        {
            case Sphere sphere:
                Line($"sphere {{ {Of(sphere.Center)}, {sphere.Radius}");
                WriteMaterial(item.Material, "1", FormattableString.Invariant($"{SwapXZ} translate {Of(sphere.Center)}"));
                break;
            case InfinitePlane plane:
                Line($"plane {{ {Of(plane.Normal)}, {Vector3D.Dot(plane.Normal, plane.Point - Point3D.Origin)}");
                WriteMaterial(item.Material, "0", FloorFrame);
                break;
            case TriangleMesh mesh:
                WriteMesh(mesh.Data, Path.Combine(folder, includeName));
                Line($"mesh2 {{ #include \"{includeName}\"");
                WriteMaterial(item.Material, null, "");
                break;
            default:
                throw new NotSupportedException($"POV-Ray scenes have spheres, planes and meshes here, not {item.Shape.GetType().Name}.");
        }

        Line($"}}");
    }

    private void WriteMaterial(Material material, string? mapType, string place)
    {
        TextureSlot ambient = material.Ambient ?? material.Diffuse;
        Texture? picture = (Texture?)(material.Diffuse.Texture ?? ambient.Texture);
        string between = interpolate ?? (picture?.Sampling.Filter == TextureFilter.Bilinear ? "interpolate 2" : "");
        string image = $"image_map {{ png \"{picture?.Path}\" gamma 1.0 map_type {mapType ?? "0"} {between} }}";
        string pigment = picture is null ? "rgb <1,1,1>" : image;
        Line($"  {(mapType is null ? "texture { uv_mapping" : "texture {")} pigment {{ {pigment} }}");
        Line($"  finish {{ ambient rgb {Of(ambient.Value)} diffuse {material.Diffuse.Value.R} specular 0 phong 0 reflection {{ rgb {Of(material.Reflection.Value)} }} }} {place} }}");
    }

    private static void WriteMesh(MeshData mesh, string path)
    {
        using StreamWriter include = new(path);
        WriteColumn(include, "vertex_vectors", mesh.Positions, mesh.VertexCount, 3);
        int normals = mesh.Normals.IsPresent ? Largest(mesh, normal: true) + 1 : 0, coordinates = mesh.TextureCoordinates.IsPresent ? Largest(mesh, normal: false) + 1 : 0;
        WriteColumn(include, "normal_vectors", mesh.Normals, normals, 3);
        WriteColumn(include, "uv_vectors", mesh.TextureCoordinates, coordinates, 2);
        WriteIndices(include, "face_indices", mesh, 0);
        if (normals > 0)
        {
            WriteIndices(include, "normal_indices", mesh, 1);
        }

        if (coordinates > 0)
        {
            WriteIndices(include, "uv_indices", mesh, 2);
        }
    }

    private static void WriteColumn(StreamWriter include, string name, MeshColumn numbers, int count, int size)
    {
        if (count == 0)
        {
            return;
        }

        include.Write(string.Create(CultureInfo.InvariantCulture, $"{name} {{ {count}"));
        for (int i = 0; i < count; i++)
        {
            string third = size == 3 ? FormattableString.Invariant($",{numbers[(size * i) + 2]}") : "";
            include.Write(string.Create(CultureInfo.InvariantCulture, $",\n<{numbers[size * i]},{numbers[(size * i) + 1]}{third}>"));
        }

        include.WriteLine(" }");
    }

    private static unsafe void WriteIndices(StreamWriter include, string name, MeshData mesh, int kind)
    {
        int* corners = kind switch { 0 => mesh.Corners, 1 => mesh.NormalCorners, _ => mesh.TextureCorners };
        include.Write(string.Create(CultureInfo.InvariantCulture, $"{name} {{ {mesh.TriangleCount}"));
        for (int i = 0; i < mesh.TriangleCount; i++)
        {
            include.Write(string.Create(CultureInfo.InvariantCulture, $",\n<{corners[3 * i]},{corners[(3 * i) + 1]},{corners[(3 * i) + 2]}>"));
        }

        include.WriteLine(" }");
    }

    private static unsafe int Largest(MeshData mesh, bool normal)
    {
        int largest = 0;
        for (int i = 0; i < 3 * mesh.TriangleCount; i++)
        {
            largest = Math.Max(largest, normal ? mesh.NormalCorners[i] : mesh.TextureCorners[i]);
        }

        return largest;
    }

    private void Line(FormattableString line) => text.WriteLine(line.ToString(CultureInfo.InvariantCulture));

    private static string Of(Point3D point) => FormattableString.Invariant($"<{point.X},{point.Y},{point.Z}>");

    private static string Of(Vector3D vector) => FormattableString.Invariant($"<{vector.X},{vector.Y},{vector.Z}>");

    private static string Of(Intensity color) => FormattableString.Invariant($"<{color.R},{color.G},{color.B}>");
}
