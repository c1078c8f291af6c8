using System.Globalization;
using System.Text;
using LabRaytracer;

namespace RenderScene;

/// <summary>A dented torus as an OBJ file with v, vt and vn: many small triangles to measure with.</summary>
internal sealed class BenchTorus(int around, int across)
{
    private const double RingRadius = 1;
    private const double TubeRadius = 0.4;

    /// <summary>Writes the file: (around + 1) x (across + 1) vertices, two triangles for each quad.</summary>
    public void Write(Stream stream)
    {
        using StreamWriter text = new(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), 1 << 16, leaveOpen: true);
        text.Write(string.Create(CultureInfo.InvariantCulture, $"# displaced torus, {around} x {across} quads\n"));
        ForEachVertex((u, v) => WriteNumbers(text, "v ", Point(u, v)));
        ForEachVertex((u, v) => WriteNumbers(text, "vt ", [u, v]));
        ForEachVertex((u, v) => WriteNumbers(text, "vn ", Normal(u, v)));
        WriteFaces(text);
    }

    private void ForEachVertex(Action<double, double> write)
    {
        for (int j = 0; j <= across; j++)
        {
            for (int i = 0; i <= around; i++)
            {
                write((double)i / around, (double)j / across);
            }
        }
    }

    private void WriteFaces(StreamWriter text)
    {
        for (int j = 0; j < across; j++)
        {
            for (int i = 0; i < around; i++)
            {
                // Vertices of an OBJ file are counted from 1. Seen from outside, u runs to the right and v up: counter-clockwise.
                int a = (j * (around + 1)) + i + 1, b = a + 1, d = a + around + 1, c = d + 1;
                text.Write(string.Create(CultureInfo.InvariantCulture, $"f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}\nf {a}/{a}/{a} {c}/{c}/{c} {d}/{d}/{d}\n"));
            }
        }
    }

    /// <summary>The surface: u around the y axis from +z towards +x, v around the tube from its outer edge over the top.</summary>
    private static double[] Point(double u, double v)
    {
        // The library's own sine: the same digits on every machine.
        double phi = 360 * u, psi = 360 * v;
        double dents = Elementary.SinCosDegrees(9 * phi).Sin * Elementary.SinCosDegrees(4 * psi).Cos, folds = Elementary.SinCosDegrees((23 * phi) + (7 * psi)).Sin;
        (double sinPhi, double cosPhi) = Elementary.SinCosDegrees(phi);
        (double sinPsi, double cosPsi) = Elementary.SinCosDegrees(psi);
        double tube = TubeRadius + (0.03 * dents) + (0.015 * folds), distance = RingRadius + (tube * cosPsi);
        return [distance * sinPhi, tube * sinPsi, distance * cosPhi];
    }

    private static double[] Normal(double u, double v)
    {
        const double Step = 1e-5;
        double[] alongU = Difference(Point(u + Step, v), Point(u - Step, v)), alongV = Difference(Point(u, v + Step), Point(u, v - Step));
        double[] normal =
        [
            (alongU[1] * alongV[2]) - (alongU[2] * alongV[1]),
            (alongU[2] * alongV[0]) - (alongU[0] * alongV[2]),
            (alongU[0] * alongV[1]) - (alongU[1] * alongV[0]),
        ];
        double length = Math.Sqrt((normal[0] * normal[0]) + (normal[1] * normal[1]) + (normal[2] * normal[2]));
        return [normal[0] / length, normal[1] / length, normal[2] / length];
    }

    private static double[] Difference(double[] a, double[] b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

    private static void WriteNumbers(StreamWriter text, string key, ReadOnlySpan<double> numbers)
    {
        text.Write(key);
        Span<char> digits = stackalloc char[32];
        for (int i = 0; i < numbers.Length; i++)
        {
            numbers[i].TryFormat(digits, out int length, "0.######", CultureInfo.InvariantCulture);
            text.Write(digits[..length]);
            text.Write(i + 1 < numbers.Length ? ' ' : '\n');
        }
    }
}
