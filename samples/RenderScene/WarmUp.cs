using System.Runtime.CompilerServices;
using LabRaytracer;

namespace RenderScene;

/// <summary>Lets the runtime compile the renderer on another processor while the command line and the scene file are read.</summary>
internal static class WarmUp
{
    private const int LargeScene = 1 << 20;

    /// <summary>Renders one tile of what most scenes have, if there is anything to compile, a render is asked for and there are two processors; failures do not matter.</summary>
    /// <param name="arguments">The words after the program's name.</param>
    public static void Start(IReadOnlyList<string> arguments)
    {
        if (RuntimeFeature.IsDynamicCodeCompiled && Environment.ProcessorCount > 1 && arguments is [] or ["render", _, ..])
        {
            Precision precision = arguments.Contains("float") || arguments.Contains("--precision=float") ? Precision.Single : Precision.Double;
            new Thread(() => Render(precision, arguments)) { IsBackground = true }.Start();
        }
    }

    /// <summary>Tells whether a scene file speaks of meshes.</summary>
    private static bool HasMesh(IReadOnlyList<string> arguments) =>
        arguments is [_, string path, ..] && new FileInfo(path) is { Exists: true, Length: < LargeScene }
        && File.ReadAllBytes(path).AsSpan().IndexOf("\"mesh\""u8) >= 0;

    private static void Render(Precision precision, IReadOnlyList<string> arguments)
    {
        try
        {
            RenderOptions options = new() { Width = 32, Height = 32, Threads = 1, Precision = precision };
            PngRowWriter writer = new(Stream.Null, options.Width, options.Height, PictureSaveOptions.Default);
            Scene scene = Ball();
            if (HasMesh(arguments))
            {
                scene.Add(new TriangleMesh([-1, 0, 0, 1, 0, 0, 0, 1, 0.1, 0, 0, 1], [0, 1, 2, 0, 1, 3]), scene.Objects[0].Material);
            }

            Renderer.Render(scene, options, writer);
            writer.Finish();
        }
        catch (Exception)
        {
            // The real render will say it, if it matters there.
        }
    }

    private static Scene Ball()
    {
        Material material = Material.Matte(Texture.FromPicture(new Picture(2, 2)));
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0, 1, 5), Point3D.Origin, 40) };
        scene.Add(new InfinitePlane(new Point3D(0, -1, 0), Vector3D.UnitY), material);
        scene.Add(new Sphere(), material);
        scene.Lights.Add(new AmbientLight(Intensity.White));
        scene.Lights.Add(new PointLight(new Point3D(4, 6, 5), Intensity.White));
        return scene;
    }
}
