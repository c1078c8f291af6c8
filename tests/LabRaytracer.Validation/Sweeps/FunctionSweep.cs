namespace LabRaytracer.Validation;

/// <summary>Elementary functions of the library against the oracle.</summary>
internal sealed class FunctionSweep(StressOptions options)
{
    private const int PerPart = 2_000;

    /// <summary>All lines of the table.</summary>
    public IEnumerable<StressRow> Run() => Run<Double1>().Concat(Run<Float1>()).Concat(Degrees());

    private List<StressRow> Run<R>()
        where R : unmanaged, IReal<R>
    {
        string format = R.IsSingle ? "float" : "double";
        Worst Of(string name, double bound) => new($"{name}, {format}", bound, "ulp");
        Worst sine = Of("sine, cosine of turns", 1.5), exp2 = Of("2^x", 1.5), log2 = Of("log2", 1.5), pow = Of("x^y of x in (0, 1]", R.IsSingle ? 4 : 32);
        Parallel.For(0, options.Parts(50), part =>
        {
            Draws draws = Draws.Of(options.Seed, "functions" + format, part);
            double Round(double a) => R.IsSingle ? (float)a : a;
            for (int i = 0; i < PerPart; i++)
            {
                double turns = Round(i % 3 == 0 ? (draws.Integer(17) / 8.0) + (draws.Sign() * draws.Scale(-17, -1)) : draws.Number(-8, 8));
                (R s, R c) = Elementary.SinCosTurns(R.Of(turns));
                (Real exactSine, Real exactCosine) = Truth.SinCosTurns(turns);
                sine.Note(Math.Max(Truth.Ulps(R.Get(s, 0), exactSine, R.IsSingle), Truth.Ulps(R.Get(c, 0), exactCosine, R.IsSingle)), $"{turns:R} turns");
                double x = Round(i % 2 == 0 ? draws.Number(-1, 1) : R.IsSingle ? draws.Number(-125, 127) : draws.Number(-1021, 1023));
                exp2.Note(Truth.Ulps(R.Get(Elementary.Exp2(R.Of(x)), 0), Truth.Exp2(x), R.IsSingle), $"2^{x:R}");
                double positive = Round(i % 2 == 0 ? 1 + (draws.Sign() * draws.Scale(-15, -0.4)) : draws.Scale(R.IsSingle ? -37 : -300, R.IsSingle ? 37 : 300));
                log2.Note(Truth.Ulps(R.Get(Elementary.Log2(R.Of(positive)), 0), Truth.Log2(positive), R.IsSingle), $"log2 {positive:R}");
                double root = Round(i % 2 == 0 ? draws.Number(0.001, 1) : 1 - draws.Scale(-6, -0.5)), power = Round(draws.Scale(-2, 5));
                if (power * Math.Log2(root) > (R.IsSingle ? -125 : -1021))
                {
                    pow.Note(Truth.Ulps(R.Get(Elementary.Pow(R.Of(root), R.Of(power)), 0), Truth.Pow(root, power), R.IsSingle), $"{root:R}^{power:R}");
                }
            }
        });
        return [sine.ToRow(), exp2.ToRow(), log2.ToRow(), pow.ToRow()];
    }

    private List<StressRow> Degrees()
    {
        Worst worst = new("sine, cosine of degrees, double", 1.5, "ulp"), tangent = new("tangent of degrees, double", 3, "ulp");
        Parallel.For(0, options.Parts(50), part =>
        {
            Draws draws = Draws.Of(options.Seed, "degrees", part);
            for (int i = 0; i < PerPart; i++)
            {
                double degrees = i % 3 == 0 ? draws.Integer(49) * 15 : draws.Number(-720, 720);
                (double sine, double cosine) = Elementary.SinCosDegrees(degrees);
                (Real exactSine, Real exactCosine) = Truth.SinCosTurns((Real)degrees / 360);
                worst.Note(Math.Max(Truth.Ulps(sine, Clean(exactSine), false), Truth.Ulps(cosine, Clean(exactCosine), false)), $"{degrees:R} degrees");
                double found = Elementary.TanDegrees(degrees);
                Real cosineOrZero = Clean(exactCosine);
                tangent.Note(
                    cosineOrZero.Sign == 0 ? double.IsInfinity(found) ? 0 : 99 : Truth.Ulps(found, Clean(exactSine) / cosineOrZero, false), $"{degrees:R} degrees");
            }
        });
        return [worst.ToRow(), tangent.ToRow()];
    }

    /// <summary>A twelfth of a turn is no binary fraction: what the oracle leaves of a zero is a zero.</summary>
    private static Real Clean(Real a) => a.Sign != 0 && a.Exponent < -180 ? 0 : a;
}
