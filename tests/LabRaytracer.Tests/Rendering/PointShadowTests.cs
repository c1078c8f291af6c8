using LabRaytracer.Tests.Geometry;

namespace LabRaytracer.Tests.Rendering;

/// <summary>Light and shadow rays of a point lamp, made in one pass, against the lamp asked point by point.</summary>
public unsafe class PointShadowTests
{
    private const int Points = 64, Hits = 61;

    private static readonly PointLight s_lamp = new(new Point3D(1, 2, 3), new Intensity(2, 1, 0.25f));

    [Theory]
    [InlineData(false, false)]
    [InlineData(false, true)]
    [InlineData(true, false)]
    public void Aim_AnyWidth_SameBitsAsOnePoint(bool fades, bool hasOwnShading) => new AimTest(fades, hasOwnShading).RunAllDoubles();

    /// <summary>Hits that nothing can shade are lit in one pass; elsewhere the shadow rays are made first. The light must not tell which.</summary>
    [Theory]
    [InlineData(false, false)]
    [InlineData(false, true)]
    [InlineData(true, false)]
    public void Add_NothingInTheWay_SameBitsAsWithShadowRays(bool fades, bool hasOwnShading) => new AimTest(fades, hasOwnShading) { IsOpen = true }.RunAllDoubles();

    private sealed class AimTest(bool fades, bool hasOwnShading) : ILaneTest
    {
        public bool IsOpen { get; init; }

        private readonly PointLight _lamp = fades ? new PointLight(s_lamp.Position, s_lamp.Intensity) { Attenuation = new Attenuation(0.5, 0.25, 0.125) } : s_lamp;

        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            Scene scene = new();
            Material material = new() { Diffuse = new Intensity(0.5f, 0.25f, 0.75f) };
            scene.Add(new InfinitePlane(), material);
            using CompiledScene<R, F, I> compiled = new(scene, null, 1);
            using LaneMemory memory = new();
            ShadingBuffers<R, F, I> buffers = new(compiled, memory, Points, hasFootprints: false);
            buffers.Surfaces.SharesNormals = !hasOwnShading;
            (Point3D[] points, Vector3D[] normals, Vector3D[] shading) = Fill(buffers.Surfaces);
            const int Bundle = 32;
            RayBounds[] bounds = new RayBounds[Points];
            int aimed = 0;
            for (int first = 0; first < Points / R.Width; first += Bundle)
            {
                aimed += PointShadows.Aim(_lamp, buffers, first, Math.Min(first + Bundle, Points / R.Width), Hits, asksAll: false, out bounds[first / Bundle]);
            }

            if (IsOpen)
            {
                CheckOpen(compiled.Keys[0].Material, buffers, aimed);
                return;
            }

            Point3D[] origins = new Point3D[Points];
            bool[] isLit = new bool[Points];
            for (int i = 0; i < Points; i++)
            {
                bool arrives = _lamp.TrySample(points[i], out LightSample light);
                isLit[i] = arrives && Vector3D.Dot(normals[i], light.Direction) > 0 && Vector3D.Dot(shading[i], light.Direction) > 0;
                double slack = Slack(i);
                origins[i] = new Point3D(
                    Math.FusedMultiplyAdd(slack, normals[i].X, points[i].X), Math.FusedMultiplyAdd(slack, normals[i].Y, points[i].Y), Math.FusedMultiplyAdd(slack, normals[i].Z, points[i].Z));
                Assert.Equal(new Ray(origins[i], light.Direction), buffers.ShadowRays[i]);
                Assert.Equal(isLit[i] ? light.Distance : -1, R.Take(buffers.ShadowRays.Limit, i));
                Assert.Equal(isLit[i] ? light.Intensity : Intensity.Black, buffers.Light.Intensity.Take(i));
                Assert.Equal(isLit[i] ? Cosine(shading[i], light.Direction) : 0, ((float*)buffers.Light.Cosine)[i]);
            }

            Assert.Equal(isLit.Take(Hits).Count(lit => lit), aimed);
            Assert.InRange(aimed, 10, 50);
            int bundle = Bundle * R.Width;
            for (int first = 0; first < Points; first += bundle)
            {
                Point3D[] lit = [.. Enumerable.Range(first, Math.Min(bundle, Points - first)).Where(i => isLit[i]).Select(i => origins[i])];
                Point3D least = new(lit.Min(p => p.X), lit.Min(p => p.Y), lit.Min(p => p.Z)), largest = new(lit.Max(p => p.X), lit.Max(p => p.Y), lit.Max(p => p.Z));
                Assert.Equal((least, largest), (bounds[first / bundle].LeastOrigin, bounds[first / bundle].LargestOrigin));
                Assert.Equal((_lamp.Position - largest, _lamp.Position - least), (bounds[first / bundle].LeastDirection, bounds[first / bundle].LargestDirection));
                Assert.True(bounds[first / bundle].Limit > 1);
            }
        }

        /// <summary>Light of all hits by way of the shadow rays, then without.</summary>
        private void CheckOpen<R, F, I>(CompiledMaterial material, ShadingBuffers<R, F, I> buffers, int aimed)
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            int packets = Points / R.Width;
            Intensity[] Radiance() => [.. Enumerable.Range(0, Points).Select(buffers.Radiance.Take)];
            void Start() => Enumerable.Range(0, Points).ToList().ForEach(i => buffers.Radiance.Put(i, new Intensity(0.125f, i / 64f, 0)));
            Start();
            Intensity[] before = Radiance();
            MatteLight.Add(material, buffers, 0, packets, isKnown: true);
            Intensity[] expected = Radiance();
            Start();
            Assert.Equal(aimed, OpenLight.Add(_lamp, material, buffers, 0, packets, Hits));
            Assert.Equal(expected, Radiance());
            Assert.InRange(Enumerable.Range(0, Hits).Count(i => before[i] != expected[i]), aimed, aimed);
        }

        /// <summary>The first point is the lamp itself, where no light arrives.</summary>
        private (Point3D[] Points, Vector3D[] Normals, Vector3D[] Shading) Fill<R, F, I>(SurfaceBatch<R, F, I> surfaces)
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            ShapeCases cases = new(8);
            Vector3D Direction() => (cases.Center(1) - Point3D.Origin).Normalized();
            Point3D[] points = [_lamp.Position, .. Enumerable.Range(1, Points - 1).Select(_ => cases.Center(3))];
            Vector3D[] normals = [.. points.Select(_ => Direction())], shading = hasOwnShading ? [.. points.Select(_ => Direction())] : normals;
            for (int i = 0; i < Points; i++)
            {
                Put(surfaces.PointX, surfaces.PointY, surfaces.PointZ, i, points[i] - Point3D.Origin);
                Put(surfaces.NormalX, surfaces.NormalY, surfaces.NormalZ, i, normals[i]);
                Put(surfaces.ShadingX, surfaces.ShadingY, surfaces.ShadingZ, i, shading[i]);
                R.Put(surfaces.Slack, i, Slack(i));
            }

            return (points, normals, shading);

            static void Put(R* x, R* y, R* z, int i, Vector3D value)
            {
                R.Put(x, i, value.X);
                R.Put(y, i, value.Y);
                R.Put(z, i, value.Z);
            }
        }

        private static double Slack(int i) => 1e-3 * (i + 1);

        private static float Cosine(Vector3D a, Vector3D b)
        {
            float z = (float)a.Z * (float)b.Z;
            return Math.Max(MathF.FusedMultiplyAdd((float)a.X, (float)b.X, MathF.FusedMultiplyAdd((float)a.Y, (float)b.Y, z)), 0);
        }
    }
}
