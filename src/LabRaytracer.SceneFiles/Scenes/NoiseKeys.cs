namespace LabRaytracer;

/// <summary>The keys of a noise, which several textures have.</summary>
/// <param name="standard">The noise where the keys are left out.</param>
internal sealed class NoiseKeys(Noise standard)
{
    private readonly Key<NoiseKind> _kind = Key.Optional(
        "noise", ChoiceFormat.Of<NoiseKind>(), standard.Kind, "Lattice noise: smooth gradients (Perlin), values with linear or with cubic interpolation, or gradients at the corners of tetrahedra (simplex).");

    private readonly Key<NoiseSum> _sum = Key.Optional(
        "sum", ChoiceFormat.Of<NoiseSum>(), standard.Sum, "Octaves as they are (fractional Brownian motion), or their absolute values (turbulence).");

    private readonly Key<int> _octaves = Key.Optional("octaves", new IntegerFormat(1, 16), standard.Octaves, "Number of octaves.");

    private readonly Key<double> _lacunarity = Key.Optional(
        "lacunarity", new NumberFormat { Min = 1, Max = 16 }, standard.Lacunarity, "Frequency of an octave relative to the one before.");

    private readonly Key<double> _gain = Key.Optional("gain", NumberFormat.Share, standard.Gain, "Weight of an octave relative to the one before.");

    private readonly Key<int> _seed = Key.Optional("seed", new IntegerFormat(int.MinValue, int.MaxValue), 0, "Chooses one of many patterns.");

    /// <summary>All keys.</summary>
    public Key[] All => [_kind, _sum, _octaves, _lacunarity, _gain, _seed];

    /// <summary>The noise.</summary>
    public Noise Get(Fields fields) => new()
    {
        Kind = fields.Get(_kind),
        Sum = fields.Get(_sum),
        Octaves = fields.Get(_octaves),
        Lacunarity = fields.Get(_lacunarity),
        Gain = fields.Get(_gain),
        Seed = fields.Get(_seed),
    };
}
