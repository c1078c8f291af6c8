using System.Globalization;

namespace LabRaytracer.Tests;

/// <summary>One row of an oracle file: a name, numbers, and exact results as nearest number and rest in ulp.</summary>
internal sealed record OracleRow(string Name, double[] Inputs, (double Nearest, double Left)[] Results)
{
    /// <summary>Rows of <c>Oracle/NAME-double.txt</c> or <c>Oracle/NAME-float.txt</c>.</summary>
    public static OracleRow[] Read(string name, int inputs, bool single)
    {
        string path = Path.Combine(AppContext.BaseDirectory, "Oracle", $"{name}-{(single ? "float" : "double")}.txt");
        return [.. File.ReadLines(path).Where(line => line[0] != '#').Select(line => Parse(line.Split(' '), inputs, single))];
    }

    private static OracleRow Parse(string[] words, int inputs, bool single)
    {
        double Number(string bits) => single
            ? BitConverter.Int32BitsToSingle(int.Parse(bits, NumberStyles.HexNumber, CultureInfo.InvariantCulture))
            : BitConverter.Int64BitsToDouble(long.Parse(bits, NumberStyles.HexNumber, CultureInfo.InvariantCulture));
        var results = new (double, double)[(words.Length - 1 - inputs) / 2];
        for (int i = 0; i < results.Length; i++)
        {
            results[i] = (Number(words[1 + inputs + (2 * i)]), double.Parse(words[2 + inputs + (2 * i)], CultureInfo.InvariantCulture));
        }

        return new OracleRow(words[0], [.. words.Skip(1).Take(inputs).Select(Number)], results);
    }
}
