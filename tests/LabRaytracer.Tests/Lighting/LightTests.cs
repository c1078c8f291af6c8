using LabRaytracer.Tests.Geometry;

namespace LabRaytracer.Tests.Lighting;

public sealed class LightTests
{
    private static readonly Intensity s_orange = new(2, 1, 0.25f);

    [Fact]
    public void TrySample_PointLight_FadesByItsAttenuation()
    {
        PointLight light = new(new Point3D(0, 3, 4), s_orange) { Attenuation = new Attenuation(1, 0.5, 0.02) };
        Assert.True(light.TrySample(Point3D.Origin, out LightSample sample));

        // 1 / (1 + 0.5 * 5 + 0.02 * 25) = 1 / 4
        Assert.Equal(5, sample.Distance);
        Assert.Equal(new Vector3D(0, 0.6, 0.8), sample.Direction);
        Assert.Equal(new Intensity(0.5f, 0.25f, 0.0625f), sample.Intensity);
    }

    [Fact]
    public void TrySample_AtTheLampItself_NoLightAndNoNaN()
    {
        Light[] lights = [new PointLight(new Point3D(1, 2, 3), s_orange) { Attenuation = new Attenuation(0, 0, 1) }, new SpotLight(new Point3D(1, 2, 3), Point3D.Origin, s_orange, 30, 20)];
        foreach (Light light in lights)
        {
            Assert.False(light.TrySample(new Point3D(1, 2, 3), out LightSample sample));
            Assert.True(sample.Direction.IsFinite);
            Assert.Equal(Intensity.Black, sample.Intensity);
        }
    }

    [Fact]
    public void TrySample_Directional_ComesFromTheOtherSideAtAnyDistance()
    {
        Assert.True(new DirectionalLight(new Vector3D(0, -2, 0), s_orange).TrySample(new Point3D(7, 8, 9), out LightSample sample));
        Assert.Equal(new LightSample(new Vector3D(0, 1, 0), double.PositiveInfinity, s_orange), sample);
    }

    [Fact]
    public void TrySample_Ambient_HasNoDirection() => Assert.False(new AmbientLight(s_orange).TrySample(Point3D.Origin, out _));

    [Theory]
    [InlineData(0, 1)]
    [InlineData(19.9, 1)]
    [InlineData(30.1, 0)]
    [InlineData(90, 0)]
    [InlineData(180, 0)]
    public void TrySample_SpotLight_LightsItsCone(double degrees, float share)
    {
        (double sin, double cos) = Math.SinCos(degrees * Math.PI / 180);
        SpotLight light = new(Point3D.Origin, new Point3D(0, 0, -1), s_orange, 30, 20);
        Assert.Equal(share > 0, light.TrySample(new Point3D(5 * sin, 0, -5 * cos), out LightSample sample));
        Assert.Equal(s_orange * share, sample.Intensity);
    }

    [Fact]
    public void TrySample_SpotLightHalfwayInCosine_GivesHalf()
    {
        // Outer 90 degrees (cosine 0), inner 0 degrees (cosine 1): at 60 degrees the step is 1/2, and 1/4 (3 - 1) = 1/2.
        SpotLight light = new(Point3D.Origin, new Point3D(0, -1, 0), s_orange, 90, 0);
        light.TrySample(new Point3D(Math.Sqrt(3), -1, 0), out LightSample sample);
        Assert.Equal(1, sample.Intensity.R, 1e-6f);
        Assert.Equal(2, sample.Distance, 1e-15);
    }

    [Fact]
    public void TrySample_SpotLightWithSharpEdge_IsOnOrOff()
    {
        SpotLight light = new(Point3D.Origin, new Point3D(0, -1, 0), s_orange, 45, 45);
        Assert.True(light.TrySample(new Point3D(0.99, -1, 0), out LightSample sample));
        Assert.Equal(s_orange, sample.Intensity);
        Assert.False(light.TrySample(new Point3D(1.01, -1, 0), out _));
    }

    [Fact]
    public void Sample_AnyWidth_SameBitsAsOnePoint() => new WideTest().RunAllDoubles();

    private sealed unsafe class WideTest : ILaneTest
    {
        public void Run<R, F, I>()
            where R : unmanaged, ILane<R, F, I>
            where F : unmanaged, ILane<F, F, I>
            where I : unmanaged, IIndexLane<I>
        {
            Light[] lights =
            [
                new PointLight(new Point3D(1, 2, 3), s_orange) { Attenuation = new Attenuation(0.1, 0.2, 0.3) },
                new PointLight(new Point3D(1, 2, 3), s_orange),
                new DirectionalLight(new Vector3D(1, -2, 3), s_orange),
                new SpotLight(new Point3D(1, 2, 3), Point3D.Origin, s_orange, 40, 10) { Attenuation = new Attenuation(0, 1, 0) },
                new SpotLight(new Point3D(1, 2, 3), Point3D.Origin, s_orange, 40, 40),
            ];
            using LaneMemory memory = new();
            SurfaceBatch<R, F, I> surfaces = new(memory, 64);
            LightColumns<R, F> samples = new(memory, 64);
            ShapeCases cases = new(8);
            Point3D[] points = [new Point3D(1, 2, 3), .. Enumerable.Range(1, 63).Select(_ => cases.Center(3))];
            for (int i = 0; i < 64; i++)
            {
                R.Put(surfaces.PointX, i, points[i].X);
                R.Put(surfaces.PointY, i, points[i].Y);
                R.Put(surfaces.PointZ, i, points[i].Z);
            }

            foreach (Light light in lights)
            {
                ((IWideLight)light).Sample(surfaces, samples, 64 / R.Width);
                for (int i = 0; i < 64; i++)
                {
                    bool arrives = light.TrySample(points[i], out LightSample expected);
                    LightSample found = new(
                        new Vector3D(R.Take(samples.DirectionX, i), R.Take(samples.DirectionY, i), R.Take(samples.DirectionZ, i)),
                        R.Take(samples.Distance, i),
                        samples.Intensity.Take(i));
                    Assert.Equal(expected, found);
                    Assert.Equal(arrives, found.Intensity != Intensity.Black);
                }
            }
        }
    }
}
