namespace LabRaytracer.Tests.Texturing;

/// <summary>What noises promise wherever they are asked.</summary>
public sealed class NoiseTests
{
    public static TheoryData<NoiseKind> Kinds => [.. Enum.GetValues<NoiseKind>()];

    [Fact]
    public void Gradient_LatticePoints_AreZero()
    {
        var noise = new Noise();
        for (int i = 0; i < 500; i++)
        {
            Assert.Equal(0, noise.At(new Point3D((i * 7) - 1000, (i * 31) - 90000, i * 1999)));
        }
    }

    [Theory, MemberData(nameof(Kinds))]
    public void At_ManyPoints_StaysInBoundAndUsesHalfOfIt(NoiseKind kind)
    {
        var noise = new Noise { Kind = kind, Octaves = 2 };
        var single = new Noise { Kind = kind };
        var random = new Random(5);
        double most = 0, sum = 0;
        for (int i = 0; i < 20000; i++)
        {
            Point3D p = Anywhere(random, 1000);
            Assert.InRange(Math.Abs(noise.At(p)), 0, noise.Bound);
            most = Math.Max(most, Math.Abs(single.At(p)));
            sum += single.At(p);
        }

        Assert.InRange(most, 0.75 * single.Bound, single.Bound);
        Assert.InRange(sum / 20000, -0.01, 0.01);
    }

    /// <summary>Across a cell's face values agree, and slopes of the noises that promise them: one-sided differences over 2^-9 differ by a step's worth of curvature.</summary>
    [Theory]
    [InlineData(NoiseKind.Gradient, true)]
    [InlineData(NoiseKind.Value, false)]
    [InlineData(NoiseKind.Cubic, true)]
    public void At_BothSidesOfAFace_IsContinuousWithItsSlope(NoiseKind kind, bool isSmooth)
    {
        const double step = 1.0 / 512;
        var noise = new Noise { Kind = kind, Seed = 3 };
        var random = new Random(6);
        double worst = 0;
        for (int i = 0; i < 300; i++)
        {
            Point3D p = Anywhere(random, 50) with { X = random.Next(-50, 50) };
            double Along(double x) => noise.At(p with { X = p.X + x });
            Assert.Equal(Along(0), Along(-1e-7), 1e-5);
            worst = Math.Max(worst, Math.Abs(Along(step) - (2 * Along(0)) + Along(-step)) / step);
        }

        Assert.True(isSmooth ? worst < 0.05 : worst > 0.5, $"slopes differ by {worst}");
    }

    /// <summary>Eight digits at a million, and no mirror at 0: a pattern is the same however far from the origin it is looked at.</summary>
    [Theory, MemberData(nameof(Kinds))]
    public void At_FarAndNegativeCoordinates_AreAsFineAsNearOnes(NoiseKind kind)
    {
        var noise = new Noise { Kind = kind };
        foreach (double at in new[] { 1000000.37, -1000000.37, 123456789.37, -0.37, 16777215.37, -16777216.63 })
        {
            double here = noise.At(new Point3D(at, 0.3, 0.6)), beside = noise.At(new Point3D(at + (1 / 1024.0), 0.3, 0.6));
            Assert.InRange(Math.Abs(here - beside), 1e-7, 0.02);
            Assert.NotEqual(here, noise.At(new Point3D(-at, 0.3, 0.6)));

            // Squeezed cells repeat after three times as many, and their numbers are rounded on the way.
            bool isSqueezed = kind == NoiseKind.Simplex;
            double again = noise.At(new Point3D(at + ((isSqueezed ? 3 : 1) * (1 << 24)), 0.3, 0.6));
            Assert.InRange(Math.Abs(here - again), 0, isSqueezed ? 1e-6 : 0);
        }
    }

    /// <summary>Corners of the tetrahedra: whole numbers i less (i + j + k) / 6; multiples of 6 are exact.</summary>
    [Fact]
    public void Simplex_Corners_AreZero()
    {
        var noise = new Noise { Kind = NoiseKind.Simplex };
        for (int i = 0; i < 500; i++)
        {
            int x = (i * 7) - 1000, y = (i * 31) - 90000, z = -(x + y) + (6 * (i - 250)), shift = i - 250;
            Assert.Equal(0, noise.At(new Point3D(x - shift, y - shift, z - shift)), 1e-6);
        }
    }

    /// <summary>
    /// Across the faces of tetrahedra, which lie where two of the coordinates are equal: second differences over 2^-7 are those of a curve without a crease, whose second
    /// derivative is at most 40.1 (the largest of six million random places, by the definition in C).
    /// </summary>
    [Theory]
    [InlineData(0, 1)]
    [InlineData(1, 2)]
    [InlineData(0, 2)]
    public void Simplex_BothSidesOfATetrahedron_IsSmooth(int first, int second)
    {
        const double step = 1.0 / 128;
        var noise = new Noise { Kind = NoiseKind.Simplex, Seed = 4 };
        var random = new Random(8);
        for (int i = 0; i < 300; i++)
        {
            Point3D p = Anywhere(random, 50);
            double[] at = [p.X, p.Y, p.Z];

            // Two alike, or x + (x + y + z) / 3 a whole number n: x = (3 n - y - z) / 4.
            at[first] = i % 2 == 0 ? at[second] : ((3 * Math.Floor(at[first])) - (at[0] + at[1] + at[2] - at[first])) / 4;
            double Across(double x) => noise.At(new Point3D(at[0] + (first == 0 ? x : 0), at[1] + (first == 1 ? x : 0), at[2]));
            Assert.InRange(Math.Abs(Across(step) - (2 * Across(0)) + Across(-step)), 0, 42 * step * step);
        }
    }

    [Fact]
    public void At_OtherSeeds_AreOtherPatterns()
    {
        Point3D p = new(0.3, 0.4, 0.7);
        float[] values = [.. Enumerable.Range(-50, 100).Select(seed => new Noise { Seed = seed }.At(p))];
        Assert.InRange(values.Distinct().Count(), 60, 100);
    }

    [Fact]
    public void Octaves_WeighGainToTheirNumber()
    {
        var first = new Noise { Seed = 9 };
        Assert.Equal(first.At(new Point3D(0.2, 0.3, 0.4)), new Noise { Seed = 9, Octaves = 5, Gain = 0 }.At(new Point3D(0.2, 0.3, 0.4)));
        Assert.All(Enumerable.Range(0, 100), i => Assert.True(new Noise { Sum = NoiseSum.Turbulence, Octaves = 4 }.At(new Point3D(0.17 * i, 0.3, 0.4)) >= 0));
    }

    /// <summary>The means that stand in for octaves that cannot be seen, against 40000 points: within four standard errors of the mean.</summary>
    [Theory, MemberData(nameof(Kinds))]
    public void Turbulence_WideFilter_IsTheMean(NoiseKind kind)
    {
        var texture = new NoiseTexture { Frequency = 1, Noise = new Noise { Kind = kind, Sum = NoiseSum.Turbulence } };
        var random = new Random(7);
        foreach (PatternSpace space in Enum.GetValues<PatternSpace>())
        {
            var here = new NoiseTexture { Frequency = 1, Noise = texture.Noise, Space = space };
            double mean = Enumerable.Range(0, 40000).Average(_ => here.Sample(Lookup(Anywhere(random, 500), 0)).R);
            Assert.Equal(mean, here.Sample(Lookup(Point3D.Origin, 0.5)).R, 0.005);
        }
    }

    [Fact]
    public void Filter_OctavesAboveHalfAFootprint_AreGone()
    {
        var one = new NoiseTexture { Noise = new Noise { Seed = 2 }, Frequency = 1 };
        var many = new NoiseTexture { Noise = new Noise { Seed = 2, Octaves = 8 }, Frequency = 1 };
        Point3D p = new(0.3, 0.4, 0.7);
        double first = (2 * one.Sample(Lookup(p, 0)).R) - 1, kept = (2 * many.Sample(Lookup(p, 0.25)).R) - 1;
        Assert.Equal(first / (2 - (1 / 128.0)), kept, 1e-6);
        Assert.Equal(0.5f, many.Sample(Lookup(p, 0.5)).R);
        Assert.Equal(many.Sample(Lookup(p, 0)).R, many.Sample(Lookup(p, 0.25 / 128)).R);
    }

    private static TextureLookup Lookup(Point3D p, double width) => new(new TextureCoordinate(p.X, p.Y), p)
    {
        Footprint = new TextureFootprint(width, 0, 0, width / 2), LocalFootprint = new SurfaceFootprint(new Vector3D(width, 0, 0), default),
    };

    private static Point3D Anywhere(Random random, double reach)
    {
        double Next() => reach * ((2 * random.NextDouble()) - 1);
        return new Point3D(Next(), Next(), Next());
    }
}
