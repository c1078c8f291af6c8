namespace LabRaytracer.Benchmarks;

/// <summary>Time a pixel against the number of spheres, and of triangles; one sample a pixel, all threads.</summary>
internal sealed class ScalingSweep(BenchPlan plan, Measures measures, Action<string> say)
{
    /// <summary>Names in results, followed by the number.</summary>
    public const string Spheres = "spheres", Triangles = "triangles";

    /// <summary>Measures powers of ten.</summary>
    public void Run()
    {
        for (int count = 10; count <= plan.MostSpheres; count *= 10)
        {
            Measure(Spheres, count, SphereCloud(count));
        }

        for (int count = 1000; count <= plan.MostTriangles; count *= 10)
        {
            Measure(Triangles, count, Mesh(count));
        }

        if (plan.MostTriangles > 1_000_000)
        {
            Measure(Triangles, plan.MostTriangles, Mesh(plan.MostTriangles));
        }
    }

    private void Measure(string kind, int count, Scene scene)
    {
        string name = FormattableString.Invariant($"{kind} {count}");
        say(name);
        RenderOptions options = SceneRun.Options(plan, Environment.ProcessorCount);
        for (int round = 0; round < plan.Rounds; round++)
        {
            RenderStatistics statistics = SceneRun.RenderWarm(scene, options);
            measures.Add(name, SceneRun.Ours, "double, all threads", "picture", statistics.RenderSeconds);
            measures.Add(name, SceneRun.Ours, "double, all threads", "prepare", statistics.PrepareSeconds);
        }
    }

    /// <summary>Spheres at pseudo-random places of a cube, so large that together they cover about the same part of the picture for every number.</summary>
    private static Scene SphereCloud(int count)
    {
        Scene scene = Lit(new PerspectiveCamera(new Point3D(0, 0, 3.5), Point3D.Origin, 40));
        Material material = Material.Matte(new CheckerTexture());
        Random random = new(1);
        double radius = 0.5 / Math.Sqrt(count);
        for (int i = 0; i < count; i++)
        {
            scene.Add(new Sphere(new Point3D((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1), radius), material);
        }

        return scene;
    }

    /// <summary>A wavy sheet of about so many triangles.</summary>
    private static Scene Mesh(int count)
    {
        int side = (int)Math.Sqrt(count / 2.0), line = side + 1;
        double[] positions = new double[3 * line * line];
        List<int> corners = new(6 * side * side);
        for (int vertex = 0; vertex < line * line; vertex++)
        {
            double x = (2.0 * (vertex % line) / side) - 1, z = (2.0 * (vertex / line) / side) - 1;
            (positions[3 * vertex], positions[(3 * vertex) + 1], positions[(3 * vertex) + 2]) = (x, 0.1 * Math.Sin(9 * x) * Math.Cos(7 * z), z);
            if (vertex % line < side && vertex / line < side)
            {
                corners.AddRange([vertex, vertex + line, vertex + 1, vertex + 1, vertex + line, vertex + line + 1]);
            }
        }

        Scene scene = Lit(new PerspectiveCamera(new Point3D(0, 1.5, 2), Point3D.Origin, 40));
        scene.Add(new TriangleMesh(positions, corners.ToArray()), new Material { Diffuse = Intensity.Grey(0.7f) });
        return scene;
    }

    private static Scene Lit(Camera camera)
    {
        Scene scene = new() { Camera = camera, Background = Intensity.Grey(0.3f) };
        scene.Lights.Add(new AmbientLight(Intensity.Grey(0.2f)));
        scene.Lights.Add(new PointLight(new Point3D(3, 5, 4), Intensity.White));
        return scene;
    }
}
