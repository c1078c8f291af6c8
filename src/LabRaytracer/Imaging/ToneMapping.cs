namespace LabRaytracer;

/// <summary>From unbounded light to [0, 1]: exposure, then an operator. The only place that clamps colours.</summary>
/// <remarks>Immutable, thread safe. NaN becomes 0.</remarks>
public sealed class ToneMapping
{
    private readonly double exposure;
    private readonly float scale = 1;

    /// <summary>No change of exposure, clamped to [0, 1].</summary>
    public static ToneMapping Default { get; } = new();

    /// <summary>Exposure in stops, [-64, 64], default 0: light is multiplied by 2^Exposure.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The exposure is outside of its range or NaN.</exception>
    public double Exposure
    {
        get => exposure;
        init
        {
            if (!(value is >= -64 and <= 64))
            {
                throw new ArgumentOutOfRangeException(nameof(value), value, "The exposure must be in [-64, 64] stops; 0 leaves light as it is.");
            }

            exposure = value;
            double whole = Math.Floor(value);
            scale = (float)Math.ScaleB(PortablePower.Pow(2, value - whole), (int)whole);
        }
    }

    /// <summary>The operator; default <see cref="ToneOperator.Clamp"/>.</summary>
    public ToneOperator Operator { get; init => field = PropertyChecks.Known(value); } = ToneOperator.Clamp;

    /// <summary>Whether in-range light comes out with the same bits.</summary>
    internal bool IsPlainClamp => scale == 1 && Operator == ToneOperator.Clamp;

    /// <summary>Displayable light of a colour: every component in [0, 1].</summary>
    /// <param name="light">Linear light, any value.</param>
    public Intensity Apply(Intensity light) => new(Apply(light.R), Apply(light.G), Apply(light.B));

    /// <summary>Displayable light of one component, in [0, 1].</summary>
    /// <param name="light">Linear light, any value; NaN gives 0.</param>
    public float Apply(float light)
    {
        float exposed = light * scale;
        if (!(exposed > 0))
        {
            return 0;
        }

        // 1 - 1/(1 + x) would lose small x; x / (1 + x) is NaN only at infinity, where the limit is 1.
        if (Operator == ToneOperator.Reinhard)
        {
            return float.IsPositiveInfinity(exposed) ? 1 : exposed / (1 + exposed);
        }

        if (Operator == ToneOperator.Aces)
        {
            // Above 1000 the curve is cut anyway; squares of larger numbers would overflow.
            double x = Math.Min(exposed, 1000);
            return (float)Math.Min(1, x * ((2.51 * x) + 0.03) / ((x * ((2.43 * x) + 0.59)) + 0.14));
        }

        return exposed > 1 ? 1 : exposed;
    }
}
