using System.Text.RegularExpressions;

namespace LabRaytracer.Tests.Architecture;

/// <summary>Rules that the compiler does not check.</summary>
public sealed partial class SourceRuleTests
{
    /// <summary>Uses of functions whose last bits depend on the machine, and why they decide no pixel.</summary>
    private static readonly Dictionary<string, string> s_inexactAllowed = new()
    {
        ["src/LabRaytracer/Mapping/TexelCoordinates.cs"] = "Program 2 of the sheet, operation by operation; rendering does not call it",
        ["src/LabRaytracer/Imaging/Codecs/Adler32.cs"] = "Vector<uint>: sums of integers, exact at any width",
        ["src/LabRaytracer/Imaging/Codecs/PngBandCompressor.cs"] = "Vector<byte>: sums of integers, exact at any width",
        ["src/LabRaytracer/Imaging/Codecs/PngUnfilter.cs"] = "Vector<byte>: sums of integers, exact at any width",
        ["src/LabRaytracer/Imaging/Codecs/RowEncoder.cs"] = "Vector<double>: a product that is exact in a double, every number on its own; tested at every threshold",
        ["src/LabRaytracer/Imaging/PictureDifference.cs"] = "decibels of a report",
    };

    /// <summary>Files that are about unfinished code: this one, and the test that the exercises are still open.</summary>
    private static readonly string[] s_speakOfHoles = ["SourceRuleTests.cs", "ExerciseTests.cs"];

    [Fact]
    public void VectorIntrinsics_AreInOneFolderOnly() => Assert.All(
        SourceTree.Files("src").Concat(SourceTree.Files("samples")).Where(file => SourceTree.Code(file).Contains("System.Runtime.Intrinsics", StringComparison.Ordinal)),
        file => Assert.StartsWith("src/LabRaytracer/Numerics/Lanes/", file, StringComparison.Ordinal));

    [Fact]
    public void TheSrgbCurve_HasOneHome()
    {
        string[] homes = [.. SourceTree.Files("src").Concat(SourceTree.Files("samples")).Where(file => SrgbNumbers().IsMatch(SourceTree.Code(file)))];
        Assert.Equal(["src/LabRaytracer/Imaging/TransferFunction.cs"], homes);
    }

    [Fact]
    public void FunctionsWhoseLastBitsDependOnTheMachine_DecideNoPixel()
    {
        string[] users = [.. SourceTree.Files("src").Where(file => InexactFunctions().IsMatch(SourceTree.Code(file)))];
        Assert.Equal(s_inexactAllowed.Keys.Order(StringComparer.Ordinal), users);
    }

    [Fact]
    public void NoFile_IsLongerThan300Lines() => Assert.Empty(
        new[] { "src", "samples", "tests" }.SelectMany(SourceTree.Files)
            .Select(file => (File: file, Lines: SourceTree.Read(file).Count(c => c == '\n')))
            .Where(item => item.Lines > 300)
            .Order());

    [Fact]
    public void NothingIsLeftUndone() => Assert.Empty(
        new[] { "src", "samples/RenderScene", "tests" }.SelectMany(SourceTree.Files)
            .Where(file => Undone().IsMatch(SourceTree.Read(file)) && !s_speakOfHoles.Contains(Path.GetFileName(file)))
            .Order(StringComparer.Ordinal));

    [Fact]
    public void NumbersAndTexts_AreNotParsedByTheMachinesCulture() => Assert.Empty(
        SourceTree.Files("src").Where(file => CultureParse().IsMatch(SourceTree.Code(file))).Order(StringComparer.Ordinal));

    [Fact]
    public void NoFile_NamesAPlaceOnOneMachine() => Assert.Empty(
        new[] { "src", "samples", "tests" }.SelectMany(SourceTree.Files)
            .Where(file => MachinePaths().IsMatch(SourceTree.Read(file)) && !file.EndsWith("/SourceRuleTests.cs", StringComparison.Ordinal))
            .Order(StringComparer.Ordinal));

    [GeneratedRegex(@"[""\s](/home/|/root/|/Users/|/tmp/)")]
    private static partial Regex MachinePaths();

    [GeneratedRegex(@"0\.04045|1\.055\b|0\.0031308|12\.92\b")]
    private static partial Regex SrgbNumbers();

    [GeneratedRegex(@"\bMathF?\.(Sin|Cos|Tan|SinCos|Asin|Acos|Atan|Atan2|Sinh|Cosh|Tanh|Pow|Exp|Log|Log2|Log10|Cbrt)\b|\bVector<|\bReciprocal(Sqrt)?Estimate")]
    private static partial Regex InexactFunctions();

    [GeneratedRegex(@"\bTO" + @"DO\b|\bFIX" + @"ME\b|NotImplemented" + @"Exception|Skip\s*=\s*" + "\"")]
    private static partial Regex Undone();

    [GeneratedRegex(@"\b(double|float|int|long|decimal)\.(Try)?Parse\(\w+(, out [\w ?]+)?\)")]
    private static partial Regex CultureParse();
}
