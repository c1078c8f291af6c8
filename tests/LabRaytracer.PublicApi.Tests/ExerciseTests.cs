using Exercises;

namespace LabRaytracer.PublicApi.Tests;

/// <summary>The exercises can be solved, are not solved yet, and name the usual faults.</summary>
public sealed class ExerciseTests
{
    [Fact]
    public void Solutions_AreRight()
    {
        Assert.Null(MappingChecks.Rectangular(new ExerciseSolutions.Rectangular()));
        Assert.Null(MappingChecks.Cylindrical(new MyCylindricalMapping()));
        Assert.Null(MappingChecks.Spherical(new ExerciseSolutions.Spherical()));
        Assert.Null(TexelChecks.Repeat(ExerciseSolutions.Repeat));
        Assert.Null(TexelChecks.Bilinear(ExerciseSolutions.Bilinear));
    }

    [Fact]
    public void Holes_AreOpen()
    {
        SurfacePosition position = SurfacePosition.At(0, 0, 1);
        Assert.Throws<NotImplementedException>(() => new RectangularExercise().Map(position));
        Assert.Throws<NotImplementedException>(() => new CylindricalExercise().Map(position));
        Assert.Throws<NotImplementedException>(() => new SphericalExercise().Map(position));
        Assert.Throws<NotImplementedException>(() => WrapExercise.Repeat(0, 1));
        Assert.Throws<NotImplementedException>(() => BilinearExercise.Sample(new Texture(1, 1), 0, 0));
    }

    [Fact]
    public void UsualFaults_AreNamed()
    {
        Assert.Contains("E1", MappingChecks.Rectangular(new Faulty(p => new((p.Z + 1) / 2, (p.X - 1) / 2))), StringComparison.Ordinal);
        Assert.Contains("E2", MappingChecks.Cylindrical(new Faulty(p => new(Turn(Math.Atan(p.X / p.Z)), (p.Y + 1) / 2))), StringComparison.Ordinal);
        Assert.Contains("a whole turn more", MappingChecks.Cylindrical(new Faulty(p => new(Math.Atan2(p.X, p.Z) / (2 * Math.PI), (p.Y + 1) / 2))), StringComparison.Ordinal);
        Assert.Contains("swapped", MappingChecks.Cylindrical(new Faulty(p => new(Turn(Math.Atan2(p.Z, p.X)), (p.Y + 1) / 2))), StringComparison.Ordinal);
        Assert.Contains("upside down", MappingChecks.Spherical(new Faulty(p => new(Turn(Math.Atan2(p.X, p.Z)), Math.Acos(p.Y) / Math.PI))), StringComparison.Ordinal);
        Assert.Contains("E6", MappingChecks.Spherical(new Faulty(p => new(Turn(Math.Atan2(p.X, p.Z)), 1 - (Math.Acos(p.Y) / Math.PI)))), StringComparison.Ordinal);
        Assert.Contains("E7", MappingChecks.Spherical(new Faulty(p => new(Turn(Math.Atan2(p.X, p.Z)), 1 - (Math.Acos(Math.Clamp(p.Y, -1, 1)) / Math.PI)))), StringComparison.Ordinal);
        Assert.Contains("sign of its left side", TexelChecks.Repeat((texel, size) => texel % size), StringComparison.Ordinal);
        Assert.Contains("the colour should be", TexelChecks.Bilinear((texture, _, _) => texture.ColorMap[0, 0]), StringComparison.Ordinal);
    }

    private static double Turn(double phi) => (phi < 0 ? phi + (2 * Math.PI) : phi) / (2 * Math.PI);

    private sealed class Faulty(Func<Point3D, TextureCoordinate> map) : IMapping
    {
        public TextureCoordinate Map(in SurfacePosition position) => map(position.LocalPoint);
    }
}
