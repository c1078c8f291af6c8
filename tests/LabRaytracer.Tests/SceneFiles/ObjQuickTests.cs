using System.Globalization;
using System.Text;

namespace LabRaytracer.Tests;

/// <summary>Lines that are read quickly must say what the same lines say that are not: those with a space at their end.</summary>
public class ObjQuickTests
{
    private static readonly string[] s_numbers =
    [
        "0", "-0", "1", "-1.5", ".25", "-.75", "3.", "0.1", "123456.654321", "-0.000001", "999999999999999", "0.12345678901234", "1234567.12345678",
        "1e-3", "-2.5E+2", "+4", "0.1234567890123456789", "12345678901234567", "0.3333333333333333",
    ];

    [Fact]
    public void Read_PlainLines_SameAsLinesWithSpaces()
    {
        string text = Text();
        ObjData quick = Read(text).Data, slow = Read(text.Replace("\n", " \n", StringComparison.Ordinal)).Data;
        Assert.Equal(slow.Counts, quick.Counts);
        Assert.Equal(Bits(slow.Positions), Bits(quick.Positions));
        Assert.Equal(Bits(slow.Uvs), Bits(quick.Uvs));
        Assert.Equal(Bits(slow.Normals), Bits(quick.Normals));
        Assert.Equal(slow.PositionOf, quick.PositionOf);
        Assert.Equal(slow.UvOf, quick.UvOf);
        Assert.Equal(slow.NormalOf, quick.NormalOf);
    }

    [Fact]
    public void Read_CarriageReturns_SameAsWithout()
    {
        string text = Text();
        ObjData plain = Read(text).Data, returns = Read(text.Replace("\n", "\r\n", StringComparison.Ordinal)).Data;
        Assert.Equal(Bits(plain.Positions), Bits(returns.Positions));
        Assert.Equal(plain.PositionOf, returns.PositionOf);
    }

    [Theory]
    [InlineData("f 1/1/1 2/2/2 4001/3/3")]
    [InlineData("f 1/1/1 2/4001/2 3/3/3")]
    [InlineData("f 1 2 0")]
    [InlineData("f 1/ 2 3")]
    [InlineData("f 1 2x 3")]
    [InlineData("v 1 2")]
    [InlineData("v 1 2 -")]
    [InlineData("v 1 2 3.4.5")]
    public void Read_MistakeAmongPlainLines_IsNamed(string line)
    {
        string text = Text() + line + "\n" + Text();
        SceneFileException failure = Assert.Throws<SceneFileException>(() => Read(text));
        Assert.Equal(1 + Text().Count(c => c == '\n'), Assert.Single(failure.Errors).Line);
    }

    private static ObjReader Read(string text) => ObjReader.Read(new SceneSource("test.obj", Encoding.UTF8.GetBytes(text)), 1 << 12);

    private static long[] Bits(double[] numbers) => [.. numbers.Select(BitConverter.DoubleToInt64Bits)];

    private static string Text()
    {
        StringBuilder text = new();
        Random random = new(7);
        for (int i = 0; i < 400; i++)
        {
            text.Append(CultureInfo.InvariantCulture, $"v {Number(random)} {Number(random)} {Number(random)}\nvt {Number(random)} {Number(random)}\nvn {Number(random)} {Number(random)} {Number(random)}\n");
        }

        for (int i = 0; i < 400; i++)
        {
            int[] corner = [.. Enumerable.Range(0, 9).Select(_ => random.Next(1, 401))];
            text.Append((i % 5) switch
            {
                0 => $"f {corner[0]} {corner[1]} {corner[2]}\n",
                1 => $"f {corner[0]}/{corner[3]} {corner[1]}/{corner[4]} {corner[2]}/{corner[5]}\n",
                2 => $"f {corner[0]}//{corner[6]} {corner[1]}//{corner[7]} {corner[2]}//{corner[8]}\n",
                3 => $"f {corner[0]}/{corner[3]}/{corner[6]} {corner[1]}/{corner[4]}/{corner[7]} {corner[2]}/{corner[5]}/{corner[8]}\n",
                _ => $"f -{corner[0]} {corner[1]} -{corner[2]}\n",
            });
        }

        return text.ToString();
    }

    private static string Number(Random random) => s_numbers[random.Next(s_numbers.Length)];
}
