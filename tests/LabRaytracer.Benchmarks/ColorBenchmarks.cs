using System.Globalization;
using BenchmarkDotNet.Attributes;
using LabRaytracer.Validation;

namespace LabRaytracer.Benchmarks;

/// <summary>
/// sRGB both ways, 4096 values, one thread, time per value: the library's exactly rounded tables against the curve written with MathF.Pow and Math.Pow.
/// The column wrong counts codes, or floats, that are not the nearest ones to the exact curve.
/// </summary>
[Config(typeof(ErrorConfig<ColorBenchmarks>))]
public class ColorBenchmarks : IMeasuresErrors
{
    private const int Count = 4096;
    private readonly float[] _light = new float[Count];
    private readonly byte[] _codes = new byte[Count];
    private readonly byte[] _foundCodes = new byte[Count];
    private readonly float[] _foundLight = new float[Count];

    public ColorBenchmarks()
    {
        Draws draws = Draws.Of(2009, "colour", 0);
        for (int i = 0; i < Count; i++)
        {
            // Half of the light lies beside a threshold between two codes, where rounding is decided.
            _codes[i] = (byte)draws.Integer(256);
            double threshold = Truth.SrgbDecode(((Real)Math.Max((byte)1, _codes[i]) - 0.5) / 255).ToDouble();
            _light[i] = i % 2 == 0 ? (float)draws.Number() : MathF.BitIncrement((float)threshold);
        }
    }

    /// <inheritdoc/>
    public static IReadOnlyList<string> ErrorNames => ["wrong"];

    [Benchmark(OperationsPerInvoke = Count)]
    public void EncodeTable()
    {
        for (int i = 0; i < Count; i++)
        {
            _foundCodes[i] = ColorEncoding.Srgb8FromLinear(_light[i]);
        }
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = Count)]
    public void EncodePowF()
    {
        for (int i = 0; i < Count; i++)
        {
            float x = _light[i], y = x <= 0.0031308f ? 12.92f * x : (1.055f * MathF.Pow(x, 1 / 2.4f)) - 0.055f;
            _foundCodes[i] = (byte)((255 * y) + 0.5f);
        }
    }

    [Benchmark(OperationsPerInvoke = Count)]
    public void EncodePow()
    {
        for (int i = 0; i < Count; i++)
        {
            double x = _light[i], y = x <= 0.0031308 ? 12.92 * x : (1.055 * Math.Pow(x, 1 / 2.4)) - 0.055;
            _foundCodes[i] = (byte)((255 * y) + 0.5);
        }
    }

    [Benchmark(OperationsPerInvoke = Count)]
    public void DecodeTable()
    {
        for (int i = 0; i < Count; i++)
        {
            _foundLight[i] = ColorEncoding.LinearFromSrgb8(_codes[i]);
        }
    }

    [Benchmark(OperationsPerInvoke = Count)]
    public void DecodePowF()
    {
        for (int i = 0; i < Count; i++)
        {
            float x = _codes[i] / 255f;
            _foundLight[i] = x <= 0.04045f ? x / 12.92f : MathF.Pow((x + 0.055f) / 1.055f, 2.4f);
        }
    }

    /// <inheritdoc/>
    public IReadOnlyList<string> Errors(string method)
    {
        ((Action)Delegate.CreateDelegate(typeof(Action), this, method))();
        bool isEncoding = method.StartsWith("Encode", StringComparison.Ordinal);
        int wrong = Enumerable.Range(0, Count).Count(i => isEncoding ? !IsCode(_light[i], _foundCodes[i]) : _foundLight[i] != Nearest(_codes[i]));
        return [wrong.ToString(CultureInfo.InvariantCulture)];
    }

    /// <summary>True if a light lies between the thresholds of a code.</summary>
    private static bool IsCode(float light, int code) =>
        (code == 0 || light >= Truth.SrgbDecode(((Real)code - 0.5) / 255)) && (code == 255 || light < Truth.SrgbDecode(((Real)code + 0.5) / 255));

    private static double Nearest(int code) => Truth.Nearest(Truth.SrgbDecode((Real)code / 255), true);
}
