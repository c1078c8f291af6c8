namespace LabRaytracer.Tests.Materials;

public sealed class ShaderTests
{
    private static readonly Vector3D s_up = Vector3D.UnitY;

    // 3-4-5 directions: cosine 0.8 to the normal.
    private static readonly Vector3D s_left = new(-0.6, 0.8, 0);
    private static readonly Vector3D s_right = new(0.6, 0.8, 0);

    private static SurfaceValues Values(float shininess) => new(new Intensity(0.5f, 0.25f, 1), new Intensity(1, 0.5f, 0), shininess);

    [Fact]
    public void Reflect_PhongMirrorDirection_GivesFullHighlight()
    {
        // N.L = 0.8, R.V = 1: k_d 0.8 + k_s.
        Intensity i = PhongShader.Default.Reflect(Values(10), s_up, s_left, s_right);
        AssertClose(new Intensity(1.4f, 0.7f, 0.8f), i, 4e-6f);
    }

    [Fact]
    public void Reflect_PhongOffMirror_FollowsTheExponent()
    {
        // V = N: R.V = 0.8; 0.8^2 = 0.64.
        Intensity i = PhongShader.Default.Reflect(Values(2), s_up, s_left, s_up);
        AssertClose(new Intensity(0.4f + 0.64f, 0.2f + 0.32f, 0.8f), i, 1e-6f);
    }

    [Fact]
    public void Reflect_PhongNegativeCosineEvenExponent_MakesNoHighlight()
    {
        // R = (0.6, 0.8, 0) and V = (-0.96, 0.28, 0): R.V = -0.352, whose square is positive.
        Intensity i = PhongShader.Default.Reflect(Values(2), s_up, s_left, new Vector3D(-0.96, 0.28, 0));
        AssertClose(new Intensity(0.4f, 0.2f, 0.8f), i, 1e-6f);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Reflect_LampBelowTheSurface_IsBlack(bool phong)
    {
        IShader shader = phong ? PhongShader.Default : BlinnPhongShader.Default;
        Assert.Equal(Intensity.Black, shader.Reflect(Values(0), s_up, new Vector3D(0.6, -0.8, 0), s_right));
    }

    [Fact]
    public void Reflect_BlinnPhong_UsesTheHalfVector()
    {
        // L = (-0.6, 0.8, 0), V = (0, 0, 1) is in the plane: H = (-0.6, 0.8, 1) / sqrt(2), N.H = 0.8 / sqrt(2); squared: 0.32.
        Intensity i = BlinnPhongShader.Default.Reflect(Values(2), s_up, s_left, Vector3D.UnitZ);
        AssertClose(new Intensity(0.4f + 0.32f, 0.2f + 0.16f, 0.8f), i, 1e-6f);
    }

    [Fact]
    public void Reflect_BlinnPhongOppositeDirections_NoNaN()
    {
        Intensity i = BlinnPhongShader.Default.Reflect(Values(2), s_up, s_left, -s_left);
        AssertClose(new Intensity(0.4f, 0.2f, 0.8f), i, 1e-6f);
    }

    [Fact]
    public void Reflect_Lambert_HasNoHighlight()
    {
        Assert.False(LambertShader.Default.UsesSpecular);
        Assert.True(((IShader)PhongShader.Default).UsesSpecular);
        AssertClose(new Intensity(0.4f, 0.2f, 0.8f), LambertShader.Default.Reflect(Values(2), s_up, s_left, s_right), 1e-6f);
    }

    [Fact]
    public void Reflect_ShininessZero_GivesFullHighlightWhereTheLobeIs() => AssertClose(
        new Intensity(1.4f, 0.7f, 0.8f), PhongShader.Default.Reflect(Values(0), s_up, s_left, s_up), 1e-6f);

    [Fact]
    public void Reflect_SixteenLanes_SameBitsAsOne()
    {
        Random random = new(12);
        foreach (IWideShader shader in (IWideShader[])[PhongShader.Default, BlinnPhongShader.Default, LambertShader.Default])
        {
            for (int round = 0; round < 50; round++)
            {
                // Every fifth round without a highlight, and single lanes without one in the others.
                float[][] lanes = [.. Enumerable.Range(0, 16).Select(lane => Numbers(random, round % 5 == 0 || lane % 3 == 0))];
                shader.Reflect(Wide(lanes), out Float16 red, out Float16 green, out Float16 blue);
                for (int lane = 0; lane < 16; lane++)
                {
                    shader.Reflect(Single(lanes[lane]), out Float1 r, out Float1 g, out Float1 b);
                    Assert.Equal((r.Value, g.Value, b.Value), ((float)Float16.Get(red, lane), (float)Float16.Get(green, lane), (float)Float16.Get(blue, lane)));
                    Assert.True(float.IsFinite(r.Value) && r.Value >= 0);
                }
            }
        }
    }

    private static float[] Numbers(Random random, bool matte)
    {
        float[] directions = [.. Enumerable.Range(0, 3).SelectMany(_ => Direction(random))];
        float specular = matte ? 0 : random.NextSingle();
        return [random.NextSingle(), random.NextSingle(), random.NextSingle(), specular, specular, 0, 100 * random.NextSingle(), .. directions];
    }

    private static float[] Direction(Random random)
    {
        Vector3D v = new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.3, random.NextDouble() - 0.5).Normalized();
        return [(float)v.X, (float)v.Y, (float)v.Z];
    }

    private static ShaderLanes<Float1> Single(float[] n) => Lanes(k => new Float1(n[k]));

    private static unsafe ShaderLanes<Float16> Wide(float[][] lanes) => Lanes(k =>
    {
        Float16 value = default;
        for (int lane = 0; lane < 16; lane++)
        {
            ((float*)&value)[lane] = lanes[lane][k];
        }

        return value;
    });

    private static ShaderLanes<F> Lanes<F>(Func<int, F> n)
        where F : unmanaged, IReal<F> => new()
        {
            DiffuseR = n(0), DiffuseG = n(1), DiffuseB = n(2), SpecularR = n(3), SpecularG = n(4), SpecularB = n(5), Shininess = n(6),
            NormalX = n(7), NormalY = n(8), NormalZ = n(9), LightX = n(10), LightY = n(11), LightZ = n(12), ViewX = n(13), ViewY = n(14), ViewZ = n(15),
        };

    private static void AssertClose(Intensity expected, Intensity actual, float tolerance)
    {
        Assert.Equal(expected.R, actual.R, tolerance);
        Assert.Equal(expected.G, actual.G, tolerance);
        Assert.Equal(expected.B, actual.B, tolerance);
    }
}
