namespace LabRaytracer.Tests.Geometry;

/// <summary>Surface points of many hits on one mesh (<see cref="MeshSurfaces{Q}"/>): the bits of one lane (<see cref="MeshSurface"/>).</summary>
public class MeshSurfaceTests
{
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Surface_HitsOnOneMesh_SameBitsAsOneLane(bool isSmooth)
    {
        TriangleMesh mesh = isSmooth ? new MeshTorus(40, 30).Mesh() : MeshSamples.BumpyBall(2, 21, out _, out _);

        // Some miss, so that hits are no run of consecutive rays and the last group is not full.
        Ray[] rays = [.. Enumerable.Range(0, 300).Select(i => new Ray(new Point3D((i % 20 * 0.17) - 1.7, (i / 20 * 0.2) - 1.5, 4), new Vector3D(0.01, 0.02, -1)))];
        AssertSame<Double16, Float16, Int16, Double1>(mesh, rays);
        AssertSame<Double8, Float8, Int8, Double1>(mesh, rays);
        AssertSame<Double4, Float4, Int4, Double1>(mesh, rays);
        AssertSame<Float16, Float16, Int16, Float1>(mesh, rays);
        AssertSame<Float8, Float8, Int8, Float1>(mesh, rays);
        AssertSame<Float4, Float4, Int4, Float1>(mesh, rays);
    }

    private static unsafe void AssertSame<R, F, I, R1>(TriangleMesh mesh, Ray[] rays)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
        where R1 : unmanaged, ILane<R1, Float1, Int1>
    {
        using ShapeRun<R, F, I> run = new([mesh], Transform.Identity, 320);
        run.SetRays(rays);
        run.Nearest();
        int[] hits = run.Surface();
        Assert.InRange(hits.Length, 25, rays.Length - 25);
        for (int i = 0; i < hits.Length; i++)
        {
            int hit = hits[i];
            Ray ray = rays[hit];
            RayLanes<R1> lanes = new(R1.Of(ray.Origin.X), R1.Of(ray.Origin.Y), R1.Of(ray.Origin.Z), R1.Of(ray.Direction.X), R1.Of(ray.Direction.Y), R1.Of(ray.Direction.Z));
            MeshSurface.Compute<R1, Float1, Int1>(
                mesh.Data, lanes, new Int1(((int*)run.Hits.Part)[hit]), R1.Of(R.Take(run.Hits.A, hit)), R1.Of(R.Take(run.Hits.B, hit)), out SurfaceLanes<R1> s);
            R1[] expected =
            [
                s.PointX, s.PointY, s.PointZ, s.NormalX, s.NormalY, s.NormalZ, s.ShadingX, s.ShadingY, s.ShadingZ, s.LocalX, s.LocalY, s.LocalZ,
                s.LocalNormalX, s.LocalNormalY, s.LocalNormalZ, s.SurfaceU, s.SurfaceV, s.Slack,
            ];
            Assert.Equal(expected.Select(number => R1.Get(number, 0)), run.SurfaceNumbers(i));
        }
    }

    /// <summary>A shadow ray leaves out the triangle that it starts from: of a mesh alone as of one beside another, with normals of its own or without.</summary>
    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Single)]
    public void Render_WavyMeshWithoutNormals_SameBitsAloneAndBesideAnother(Precision precision)
    {
        const int Side = 60, Line = Side + 1;
        double[] positions = new double[3 * Line * Line];
        List<int> corners = [];
        for (int vertex = 0; vertex < Line * Line; vertex++)
        {
            double x = (2.0 * (vertex % Line) / Side) - 1, z = (2.0 * (vertex / Line) / Side) - 1;
            (positions[3 * vertex], positions[(3 * vertex) + 1], positions[(3 * vertex) + 2]) = (x, 0.1 * Math.Sin(9 * x) * Math.Cos(7 * z), z);
            if (vertex % Line < Side && vertex / Line < Side)
            {
                corners.AddRange([vertex, vertex + Line, vertex + 1, vertex + 1, vertex + Line, vertex + Line + 1]);
            }
        }

        Intensity[] Show(bool isAlone)
        {
            Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(0, 1.5, 2), Point3D.Origin, 40) };
            scene.Add(new TriangleMesh(positions, [.. corners]), new Material { Diffuse = Intensity.Grey(0.7f) });
            if (!isAlone)
            {
                scene.Add(new TriangleMesh([0, 90, 0, 1, 90, 0, 0, 91, 0], [0, 1, 2]), new Material());
            }

            scene.Lights.Add(new PointLight(new Point3D(2, 0.4, 1), Intensity.White));
            return Renderer.Render(scene, new RenderOptions { Width = 160, Height = 120, Precision = precision }).Picture.Pixels.ToArray();
        }

        Assert.Equal(Show(isAlone: false), Show(isAlone: true));
    }

    /// <summary>The first triangle of a mesh without normals shades the second one, which the camera sees from under it.</summary>
    [Theory]
    [InlineData(Precision.Double)]
    [InlineData(Precision.Single)]
    public void Render_MeshWithoutNormals_IsShadedByItsFirstTriangle(Precision precision)
    {
        Scene scene = new() { Camera = new PerspectiveCamera(new Point3D(3, 0.8, 0), Point3D.Origin, 2), Background = Intensity.White };
        scene.Add(new TriangleMesh([-1, 1, -1, 1, 1, -1, 0, 1, 1, -9, 0, -9, 9, 0, -9, 0, 0, 9], [0, 1, 2, 3, 4, 5]), new Material { Diffuse = Intensity.White });
        scene.Lights.Add(new PointLight(new Point3D(0, 5, 0), Intensity.White));
        Assert.All(Renderer.Render(scene, new RenderOptions { Width = 8, Height = 8, Precision = precision }).Picture.Pixels.ToArray(), pixel => Assert.Equal(Intensity.Black, pixel));
    }
}
