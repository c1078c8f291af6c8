namespace LabRaytracer.Tests;

/// <summary>Vectors, boxes and transforms: exact cases and rows of a 60-digit computation.</summary>
public sealed class GeometryTests
{
    [Fact]
    public void Length_HugeTinyAndSubnormal_NeitherOverflowsNorUnderflows()
    {
        Assert.Equal(5, new Vector3D(3, 0, -4).Length);
        UlpAssert.Within(1, 5e300, new Vector3D(3e300, 4e300, 0).Length);
        UlpAssert.Within(1, 5e-300, new Vector3D(0, 3e-300, 4e-300).Length);
        Assert.Equal(5 * double.Epsilon, new Vector3D(3 * double.Epsilon, 0, 4 * double.Epsilon).Length);
        Assert.Equal(0, Vector3D.Zero.Length);
        UlpAssert.Within(1, 1.7320508075688772, new Vector3D(1, 1, 1).Length); // sqrt(3)
    }

    [Fact]
    public void Cross_Axes_IsRightHanded()
    {
        Assert.Equal(Vector3D.UnitZ, Vector3D.Cross(Vector3D.UnitX, Vector3D.UnitY));
        Assert.Equal(Vector3D.UnitX, Vector3D.Cross(Vector3D.UnitY, Vector3D.UnitZ));
        Assert.Equal(Vector3D.UnitY, Vector3D.Cross(Vector3D.UnitZ, Vector3D.UnitX));
    }

    [Fact]
    public void Cross_NearlyParallel_DoesNotCancel()
    {
        // (1 + e)(1 - e) - 1 = -e², e = 2^-30: lost without the fused form.
        double e = Math.ScaleB(1, -30);
        Assert.Equal(-e * e, Vector3D.Cross(new Vector3D(1 + e, 1, 0), new Vector3D(1, 1 - e, 0)).Z);
    }

    [Fact]
    public void Normalized_AnyMagnitude_HasLengthOne()
    {
        foreach (double scale in new[] { 1e-300, 1e-9, 1, 1e9, 1e300 })
        {
            UlpAssert.Within(2, 1, (new Vector3D(0.3, -0.7, 1.9) * scale).Normalized().Length);
        }

        Assert.Throws<InvalidOperationException>(() => Vector3D.Zero.Normalized());
        Assert.Throws<InvalidOperationException>(() => new Vector3D(double.NaN, 0, 0).Normalized());
    }

    [Fact]
    public void Rotation_QuarterTurns_AreExact()
    {
        Point3D p = new(1, 2, 3);
        Assert.Equal(new Point3D(3, 2, -1), Transform.Rotation(Vector3D.UnitY, 90).WorldFromObject(p));
        Assert.Equal(new Point3D(1, -3, 2), Transform.Rotation(Vector3D.UnitX, 90).WorldFromObject(p));
        Assert.Equal(new Point3D(-1, -2, 3), Transform.Rotation(Vector3D.UnitZ, 180).WorldFromObject(p));
        Assert.Equal(p, Transform.Rotation(Vector3D.UnitZ, 720).WorldFromObject(p));
    }

    [Fact]
    public void Rotation_30DegreesAboutTheDiagonal_MatchesExactMatrix()
    {
        // First row of I cos + (1 - cos) n n^T + sin [n]x with n = (1, 1, 1) / sqrt 3: 60-digit values.
        ReadOnlySpan<double> rows = Transform.Rotation(new Vector3D(1, 1, 1), 30).WorldFromObjectRows;
        Assert.Equal(0.91068360252295909784, rows[0], 15);
        Assert.Equal(-0.24401693585629243118, rows[1], 15);
        Assert.Equal(0.33333333333333333333, rows[2], 15);
    }

    [Fact]
    public void Transform_ThereAndBack_ReturnsThePoint()
    {
        Transform map = Transform.Scaling(new Vector3D(2, -3, 0.5)).Then(Transform.Rotation(new Vector3D(1, 2, 3), 77)).Then(Transform.Translation(new Vector3D(4, 5, -6)));
        Point3D p = new(0.3, -0.8, 1.7);
        Assert.True((map.ObjectFromWorld(map.WorldFromObject(p)) - p).Length < 1e-14);
        var ray = new Ray(new Point3D(1, 1, 1), new Vector3D(0, 0, -2));
        Ray local = map.ObjectFromWorld(ray);
        Assert.True((map.WorldFromObject(local.Origin + (local.Direction * 3)) - (ray.Origin + (ray.Direction * 3))).Length < 1e-13);
        Vector3D normal = map.WorldNormalFromObject(Vector3D.UnitY), tangent = map.WorldFromObject(Vector3D.UnitX);
        Assert.True(Math.Abs(Vector3D.Dot(normal, tangent)) < 1e-14);
    }

    [Fact]
    public void Then_TranslationAndScaling_AppliesTheFirstOneFirst()
    {
        Transform map = Transform.Translation(new Vector3D(1, 0, 0)).Then(Transform.Scaling(new Vector3D(2, 2, 2)));
        Assert.Equal(new Point3D(2, 0, 0), map.WorldFromObject(Point3D.Origin));
        Assert.Equal(Point3D.Origin, map.ObjectFromWorld(new Point3D(2, 0, 0)));
        Assert.True(Transform.Identity.Then(Transform.Identity).IsIdentity);
    }

    [Fact]
    public void Transform_SingularOrNotFinite_Throws()
    {
        Assert.Throws<ArgumentException>(() => Transform.Scaling(new Vector3D(1, 0, 1)));
        Assert.Throws<ArgumentException>(() => Transform.Translation(new Vector3D(double.NaN, 0, 0)));
        Assert.Throws<ArgumentException>(() => Transform.Rotation(Vector3D.Zero, 10));
        Assert.Throws<ArgumentException>(() => Transform.Rotation(Vector3D.UnitX, double.PositiveInfinity));
        Assert.Throws<ArgumentException>(() => Transform.FromRows([1, 2, 3]));
    }

    [Fact]
    public void Bounds_UnionAndTransform_ContainEveryCorner()
    {
        Bounds box = Bounds.Empty.Including(new Point3D(1, 2, 3)).Including(new Point3D(-1, 0, 5));
        Assert.Equal(new Bounds(new Point3D(-1, 0, 3), new Point3D(1, 2, 5)), box);
        Assert.True(Bounds.Empty.IsEmpty);
        Assert.Equal(box, Bounds.Union(Bounds.Empty, box));
        Bounds turned = box.Transformed(Transform.Rotation(Vector3D.UnitY, 90));
        Assert.True(turned.Min.X <= 3 && turned.Max.X >= 5 && turned.Min.Z <= -1 && turned.Max.Z >= 1);
        Assert.True(turned.Max.X < 5.000001);
        Assert.Equal(Bounds.Everything, Bounds.Everything.Transformed(Transform.Scaling(new Vector3D(2, 2, 2))));
    }
}
