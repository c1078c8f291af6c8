namespace LabRaytracer.Tests;

public sealed class UvTransformTests
{
    private static readonly TextureCoordinate Zero = new(0, 0);
    private static readonly TextureCoordinate One = new(1, 1);

    [Fact]
    public void Identity_AnyCoordinate_Unchanged()
    {
        Assert.Equal(new TextureCoordinate(0.3, -7), UvTransform.Identity.Apply(new TextureCoordinate(0.3, -7)));
        Assert.True(UvTransform.Identity.IsIdentity);
        Assert.True(new UvTransform(Zero, 360, One, Zero).IsIdentity);
        Assert.False(new UvTransform(Zero, 90, One, Zero).IsIdentity);
    }

    [Theory]
    [InlineData(90, 1, 0, 0, 1)]
    [InlineData(90, 0, 1, -1, 0)]
    [InlineData(180, 1, 2, -1, -2)]
    [InlineData(-90, 1, 0, 0, -1)]
    public void Apply_Rotation_TurnsCounterClockwise(double degrees, double u, double v, double expectedU, double expectedV) =>
        Assert.Equal(new TextureCoordinate(expectedU, expectedV), new UvTransform(Zero, degrees, One, Zero).Apply(new TextureCoordinate(u, v)));

    [Fact]
    public void Apply_UnequalScaleAnd30Degrees_ScalesFirstThenRotatesThenMoves()
    {
        // (2 u cos 30 - 3 v sin 30 + 0.1, 2 u sin 30 + 3 v cos 30 + 0.2) at (0.5, 0.25): 60-digit values.
        TextureCoordinate found = new UvTransform(new(0.1, 0.2), 30, new(2, 3), Zero).Apply(new(0.5, 0.25));
        Assert.Equal(0.59102540378443864676, found.U, 15);
        Assert.Equal(1.34951905283832898507, found.V, 15);
    }

    [Fact]
    public void Apply_Center_StaysInPlace()
    {
        TextureCoordinate center = new(0.5, 0.25);
        TextureCoordinate found = new UvTransform(Zero, 33, new(4, 2), center).Apply(center);
        Assert.Equal(center.U, found.U, 15);
        Assert.Equal(center.V, found.V, 15);
        Assert.Equal(new TextureCoordinate(0.75, 0.5), new UvTransform(Zero, 90, One, center).Apply(new(0.75, 0)));
    }

    [Fact]
    public void Apply_EveryWidth_SameBits()
    {
        var transform = new UvTransform(new(0.1, 0.2), 30, new(2, 3), new(0.5, 0.5));
        double[] u = [.. Enumerable.Range(0, 1000).Select(i => i / 999.0)], v = [.. u.Reverse()];
        double[] expected = [.. u.Zip(v, (a, b) => transform.Apply(new TextureCoordinate(a, b)).U)];
        Assert.Equal(expected, WideMapping.Apply<Double4>((a, b) => transform.Apply(a, b).U, u, v));
        Assert.Equal(expected, WideMapping.Apply<Double8>((a, b) => transform.Apply(a, b).U, u, v));
        Assert.Equal(expected, WideMapping.Apply<Double16>((a, b) => transform.Apply(a, b).U, u, v));
    }

    [Theory]
    [InlineData(double.NaN, 0, 1)]
    [InlineData(0, double.PositiveInfinity, 1)]
    [InlineData(0, 0, double.NegativeInfinity)]
    public void Constructor_NotFinite_Throws(double offset, double degrees, double scale)
    {
        using var comma = new CommaCulture();
        ArgumentException error = Assert.Throws<ArgumentException>(() => new UvTransform(new(offset, 0), degrees, new(scale, 1), Zero));
        Assert.Contains("finite", error.Message, StringComparison.Ordinal);
    }
}
