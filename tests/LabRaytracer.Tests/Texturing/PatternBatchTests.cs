namespace LabRaytracer.Tests.Texturing;

/// <summary>Computed and combined textures: many lookups at a time give the bits of one at a time, at every width.</summary>
public sealed class PatternBatchTests
{
    private static readonly NoiseTexture s_clouds = new() { Noise = new Noise { Octaves = 3 }, Ramp = ColorRamp.Between(new Intensity(0.1f, 0.2f, 0.3f), Intensity.White) };
    private static readonly ITexture s_checker = new CheckerTexture { Columns = 3, Rows = 2 };
    private static readonly Transform s_move = Transform.Rotation(new Vector3D(1, 2, 3), 40).Then(Transform.Scaling(new Vector3D(2, 0.5, -1))).Then(Transform.Translation(new Vector3D(1, 2, 3)));

    public static TheoryData<string> Names => [.. Textures().Keys];

    [Theory, MemberData(nameof(Names))]
    public void Sample_EveryWidth_SameAsScalar(string name) => SamplerRun.SameAsScalar(Textures()[name], TextureWrap.Repeat, TextureWrap.Repeat);

    private static Dictionary<string, ITexture> Textures()
    {
        Dictionary<string, ITexture> all = new()
        {
            ["marble"] = new MarbleTexture(),
            ["marble uv"] = new MarbleTexture { Space = PatternSpace.Uv, Noise = new Noise { Kind = NoiseKind.Cubic } },
            ["wood"] = new WoodTexture(),
            ["brick"] = new BrickTexture { Variation = 0.5 },
            ["brick 0.3"] = new BrickTexture { Columns = 2.5, Rows = 0.3, Mortar = 0.9, Shift = 0.2, Variation = 1, Seed = 3 },
            ["axis"] = new GradientTexture { Kind = GradientKind.Axis, Axis = new Vector3D(1, 2, 3) },
            ["radial"] = new GradientTexture { Kind = GradientKind.Radial, Center = new Point3D(1, 0, 0) },
            ["product"] = new ProductTexture(s_clouds, s_checker),
            ["mix"] = new MixTexture(s_clouds, s_checker, new GradientTexture()),
            ["select"] = new SelectTexture(s_clouds, s_checker, new GridTexture(), 0.6),
            ["layers"] = new LayeredTexture(s_checker, new TextureCover(s_clouds, new WorleyTexture()), new TextureCover(new BrickTexture(), s_checker)),
            ["ramp"] = new RampTexture(s_clouds, ColorRamp.Between(new Intensity(1, 0, 0), new Intensity(0, 0, 1))),
            ["transformed"] = new TransformedTexture(s_clouds, s_move),
            ["transformed uv"] = new TransformedTexture(s_checker) { Uv = new UvTransform(new(0.1, 0.2), 30, new(2, 3), new(0, 0)) },
            ["transformed both"] = new TransformedTexture(new MixTexture(s_clouds, new BrickTexture()), s_move) { Uv = new UvTransform(new(0.1, 0.2), 30, new(2, 3), new(0, 0)) },
            ["world"] = new TransformedTexture(s_clouds, s_move) { Frame = TextureFrame.World },
            ["triplanar"] = new TriplanarTexture(new BrickTexture()) { Scale = 3, Sharpness = 5 },
            ["function"] = new MixTexture(new FunctionTexture(at => Intensity.Grey((float)(at.LocalPoint.X + at.Coordinate.V))), s_checker),
        };
        foreach (NoiseKind kind in Enum.GetValues<NoiseKind>())
        {
            foreach (PatternSpace space in Enum.GetValues<PatternSpace>())
            {
                all[$"{kind} {space}"] = new NoiseTexture { Noise = new Noise { Kind = kind, Octaves = 3, Sum = NoiseSum.Turbulence, Seed = -7 }, Space = space };
            }
        }

        foreach (WorleyMetric metric in Enum.GetValues<WorleyMetric>())
        {
            all[$"{metric}"] = new WorleyTexture { Metric = metric, Feature = WorleyFeature.F2 };
            all[$"{metric} uv"] = new WorleyTexture { Metric = metric, Feature = WorleyFeature.F2MinusF1, Space = PatternSpace.Uv };
        }

        return all;
    }
}
