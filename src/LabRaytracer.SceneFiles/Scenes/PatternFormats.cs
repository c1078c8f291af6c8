namespace LabRaytracer;

/// <summary>Computed textures of scene files.</summary>
internal static class PatternFormats
{
    private static readonly NoiseTexture s_noise = new();
    private static readonly WorleyTexture s_worley = new();
    private static readonly MarbleTexture s_marble = new();
    private static readonly WoodTexture s_wood = new();
    private static readonly BrickTexture s_brick = new();

    private static readonly Key<PatternSpace> s_space = Key.Optional(
        "space", ChoiceFormat.Of<PatternSpace>(), PatternSpace.Local, "Where the pattern lies: in the object's own space, or in texture space.");

    private static readonly Key<double> s_filter = Key.Optional(
        "filterWidth", new NumberFormat { Min = 0, Max = 16 }, 1, "Width of the filter in footprints of a sample; 0: none.");

    private static readonly Key<IReadOnlyList<RampFormats.StopValue>> s_ramp = RampFormats.KeyOf("Colours of the pattern's numbers. Default: as the pattern suggests.");

    private static readonly Key<int> s_seed = Key.Optional("seed", new IntegerFormat(int.MinValue, int.MaxValue), 0, "Chooses one of many patterns.");

    private static readonly NoiseKeys s_noiseKeys = new(s_noise.Noise);
    private static readonly NoiseKeys s_marbleKeys = new(s_marble.Noise);
    private static readonly NoiseKeys s_woodKeys = new(s_wood.Noise);

    private static readonly Key<double> s_frequency = Key.Optional("frequency", NumberFormat.Positive, s_noise.Frequency, "Cells of the first octave in one unit.");

    private static readonly Key<double> s_cells = Key.Optional("frequency", NumberFormat.Positive, s_worley.Frequency, "Cells in one unit.");

    private static readonly Key<WorleyFeature> s_feature = Key.Optional(
        "feature", ChoiceFormat.Of<WorleyFeature>(), s_worley.Feature, "Distance to the nearest point, to the second nearest, or their difference.");

    private static readonly Key<WorleyMetric> s_metric = Key.Optional("metric", ChoiceFormat.Of<WorleyMetric>(), s_worley.Metric, "How distance is measured.");

    private static readonly Key<double> s_stripes = Key.Optional("stripes", NumberFormat.NotNegative, s_marble.Stripes, "Veins in one unit along y.");

    private static readonly Key<double> s_marbleFrequency = Key.Optional("frequency", NumberFormat.Positive, s_marble.Frequency, "Cells of the noise in one unit.");

    private static readonly Key<double> s_marbleAmount = Key.Optional("amount", NumberFormat.Any, s_marble.Amount, "How far the noise bends the veins, in veins.");

    private static readonly Key<double> s_rings = Key.Optional("rings", NumberFormat.Positive, s_wood.Rings, "Rings in one unit away from the y axis.");

    private static readonly Key<double> s_woodFrequency = Key.Optional("frequency", NumberFormat.Positive, s_wood.Frequency, "Cells of the noise in one unit.");

    private static readonly Key<double> s_woodAmount = Key.Optional("amount", NumberFormat.Any, s_wood.Amount, "How far the noise bends the rings, in rings.");

    private static readonly Key<Intensity> s_brickColor = Key.Optional("brick", Colors.Any, s_brick.Brick, "Colour of the bricks.");

    private static readonly Key<Intensity> s_mortarColor = Key.Optional("mortarColor", Colors.Any, s_brick.MortarColor, "Colour of the mortar.");

    private static readonly Key<double> s_columns = Key.Optional("columns", NumberFormat.Positive, s_brick.Columns, "Bricks along u from 0 to 1.");

    private static readonly Key<double> s_rows = Key.Optional("rows", NumberFormat.Positive, s_brick.Rows, "Rows along v from 0 to 1.");

    private static readonly Key<double> s_mortar = Key.Optional("mortar", NumberFormat.Share, s_brick.Mortar, "Width of the mortar as a share of a row's height.");

    private static readonly Key<double> s_shift = Key.Optional("shift", NumberFormat.Share, s_brick.Shift, "How far every second row is shifted, in bricks.");

    private static readonly Key<double> s_variation = Key.Optional("variation", NumberFormat.Share, s_brick.Variation, "How much darker a brick may be, at random.");

    private static readonly Key<GradientKind> s_along = Key.Optional(
        "along", ChoiceFormat.Of<GradientKind>(), GradientKind.U, "What the gradient runs along: u, v, an axis of the object, or the distance from a point of it.");

    private static readonly Key<Vector3D> s_axis = Key.Optional("axis", Coordinates.Vector, Vector3D.UnitY, "Direction of a gradient along an axis; its length scales the places of the stops.");

    private static readonly Key<Point3D> s_center = Key.Optional("center", Coordinates.Point, Point3D.Origin, "Where a radial gradient starts.");

    /// <summary>The formats.</summary>
    public static IReadOnlyList<ObjectFormat<ITexture>> All { get; } =
    [
        new("noiseTexture", "Noise: clouds, stains.", [.. s_noiseKeys.All, s_frequency, s_space, s_ramp, s_filter], Noise, ("type", "noise")),
        new("worleyTexture", "Cells around random points: stones, scales.", [s_feature, s_metric, s_cells, s_seed, s_space, s_ramp, s_filter], Worley, ("type", "worley")),
        new("marbleTexture", "Marble: veins across y, bent by noise.", [.. s_marbleKeys.All, s_stripes, s_marbleFrequency, s_marbleAmount, s_space, s_ramp, s_filter], Marble, ("type", "marble")),
        new("woodTexture", "Wood: rings around y, bent by noise.", [.. s_woodKeys.All, s_rings, s_woodFrequency, s_woodAmount, s_space, s_ramp, s_filter], Wood, ("type", "wood")),
        new(
            "brickTexture",
            "A brick wall in texture space.",
            [s_brickColor, s_mortarColor, s_columns, s_rows, s_mortar, s_shift, s_variation, s_seed, s_filter],
            Brick,
            ("type", "brick")),
        new("gradientTexture", "A gradient of colours.", [s_along, s_axis, s_center, s_ramp], Gradient, ("type", "gradient")),
    ];

    private static NoiseTexture? Noise(Fields fields) => RampFormats.Get(fields, s_ramp, s_noise.Ramp) is not { } ramp ? null : new()
    {
        Noise = s_noiseKeys.Get(fields), Frequency = fields.Get(s_frequency), Space = fields.Get(s_space), Ramp = ramp, FilterWidth = fields.Get(s_filter),
    };

    private static WorleyTexture? Worley(Fields fields) => RampFormats.Get(fields, s_ramp, s_worley.Ramp) is not { } ramp ? null : new()
    {
        Feature = fields.Get(s_feature),
        Metric = fields.Get(s_metric),
        Frequency = fields.Get(s_cells),
        Seed = fields.Get(s_seed),
        Space = fields.Get(s_space),
        Ramp = ramp,
        FilterWidth = fields.Get(s_filter),
    };

    private static MarbleTexture? Marble(Fields fields) => RampFormats.Get(fields, s_ramp, s_marble.Ramp) is not { } ramp ? null : new()
    {
        Noise = s_marbleKeys.Get(fields),
        Stripes = fields.Get(s_stripes),
        Frequency = fields.Get(s_marbleFrequency),
        Amount = fields.Get(s_marbleAmount),
        Space = fields.Get(s_space),
        Ramp = ramp,
        FilterWidth = fields.Get(s_filter),
    };

    private static WoodTexture? Wood(Fields fields) => RampFormats.Get(fields, s_ramp, s_wood.Ramp) is not { } ramp ? null : new()
    {
        Noise = s_woodKeys.Get(fields),
        Rings = fields.Get(s_rings),
        Frequency = fields.Get(s_woodFrequency),
        Amount = fields.Get(s_woodAmount),
        Space = fields.Get(s_space),
        Ramp = ramp,
        FilterWidth = fields.Get(s_filter),
    };

    private static BrickTexture Brick(Fields fields) => new()
    {
        Brick = fields.Get(s_brickColor),
        MortarColor = fields.Get(s_mortarColor),
        Columns = fields.Get(s_columns),
        Rows = fields.Get(s_rows),
        Mortar = fields.Get(s_mortar),
        Shift = fields.Get(s_shift),
        Variation = fields.Get(s_variation),
        Seed = fields.Get(s_seed),
        FilterWidth = fields.Get(s_filter),
    };

    private static GradientTexture? Gradient(Fields fields) => RampFormats.Get(fields, s_ramp, ColorRamp.Grey) is not { } ramp ? null : new()
    {
        Kind = fields.Get(s_along), Axis = fields.Get(s_axis), Center = fields.Get(s_center), Ramp = ramp,
    };
}
