namespace LabRaytracer.Tests;

/// <summary>Reports of mappings: good ones have no fault, the usual mistakes are named with a point.</summary>
public sealed class MappingReportTests
{
    public static TheoryData<IMapping> OfTheSphere => [new SphericalMapping(), new EqualAreaMapping()];

    [Theory, MemberData(nameof(OfTheSphere))]
    public void Check_MappingOfTheSphere_HasNoFault(IMapping mapping)
    {
        MappingReport report = MappingReport.Check(mapping);
        Assert.True(report.IsGood, report.ToString());
        Assert.Contains(report.Facts, fact => fact.StartsWith("seam: u jumps by a turn", StringComparison.Ordinal));
        Assert.Contains("orientation: not mirrored seen from outside", report.Facts);
        Assert.Contains("scale: the distance from the origin does not matter", report.Facts);
    }

    [Fact]
    public void Check_UsualMistakes_AreNamed()
    {
        Assert.StartsWith("finite: ", Fault(p => (Turns(p.X, p.Z), 1 - (Math.Acos(p.Y) / Math.PI))), StringComparison.Ordinal);
        Assert.StartsWith("continuity: ", Fault(p => (Math.Atan(p.X / (p.Z == 0 ? 1e-9 : p.Z)) / (2 * Math.PI) + 0.25, 0.5)), StringComparison.Ordinal);
        Assert.StartsWith("range: ", Fault(p => (Turns(p.X, p.Z), (p.Y - 1) / 2)), StringComparison.Ordinal);
        Assert.StartsWith("range: ", Fault(p => (Math.Atan2(p.X, p.Z) / (2 * Math.PI), 0.5)), StringComparison.Ordinal);
        Assert.Contains("orientation: mirrored seen from outside", Report(p => (1 - Turns(p.X, p.Z) is var u && u >= 1 ? 0 : u, Height(p))).Facts);
        Assert.Empty(Report(p => (Turns(p.X, p.Z), Height(p))).Faults);
    }

    private static double Turns(double x, double z) => Math.Atan2(x, z) is var phi && phi < 0 ? Math.Min((phi / (2 * Math.PI)) + 1, Math.BitDecrement(1)) : phi / (2 * Math.PI);

    private static double Height(Point3D p) => 1 - (Math.Atan2(Math.Sqrt((p.X * p.X) + (p.Z * p.Z)), p.Y) / Math.PI);

    private static string Fault(Func<Point3D, (double U, double V)> map) => Report(map).Faults.FirstOrDefault() ?? "none";

    private static MappingReport Report(Func<Point3D, (double U, double V)> map) => MappingReport.Check(new Own(map));

    private sealed class Own(Func<Point3D, (double U, double V)> map) : IMapping
    {
        public TextureCoordinate Map(in SurfacePosition position)
        {
            (double u, double v) = map(position.LocalPoint);
            return new TextureCoordinate(u, v);
        }
    }
}
