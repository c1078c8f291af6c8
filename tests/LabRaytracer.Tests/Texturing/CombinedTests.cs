namespace LabRaytracer.Tests.Texturing;

/// <summary>Textures made of textures.</summary>
public sealed class CombinedTests
{
    private static readonly ITexture s_u = new GradientTexture();
    private static readonly ITexture s_red = new ConstantTexture(new Intensity(1, 0, 0));
    private static readonly ITexture s_blue = new ConstantTexture(new Intensity(0, 0, 0.5f));
    private static readonly ITexture s_black = new ConstantTexture(Intensity.Black);

    [Fact]
    public void Product_MultipliesComponents() =>
        Assert.Equal(new Intensity(0.25f, 0, 0), new ProductTexture(s_u, s_red).Sample(TextureLookup.At(0.25, 0)));

    [Theory]
    [InlineData(0, 1, 0)]
    [InlineData(0.25, 0.75, 0.125)]
    [InlineData(1, 0, 0.5)]
    public void Mix_ByGradient_IsLinear(double u, float red, float blue)
    {
        Intensity mixed = new MixTexture(s_red, s_blue, s_u).Sample(TextureLookup.At(u, 0));
        Assert.Equal(red, mixed.R, 1e-6);
        Assert.Equal(blue, mixed.B, 1e-6);
    }

    [Fact]
    public void Select_AtTheThreshold_TakesTheUpperOne()
    {
        var select = new SelectTexture(s_u, s_red, s_blue, 0.25);
        Assert.Equal(new Intensity(0, 0, 0.5f), select.Sample(TextureLookup.At(0.25, 0)));
        Assert.Equal(new Intensity(1, 0, 0), select.Sample(TextureLookup.At(0.2499, 0)));
    }

    [Fact]
    public void Layers_CoverWhatIsBelow()
    {
        var half = new ConstantTexture(Intensity.Grey(0.5f));
        var stack = new LayeredTexture(s_red, new TextureCover(s_blue, half), new TextureCover(s_u, half));
        Assert.Equal(new Intensity(0.375f, 0.125f, 0.25f), stack.Sample(TextureLookup.At(0.25, 0)));
    }

    [Fact]
    public void Ramp_ColoursLuminance()
    {
        var ramp = new ColorRamp(new ColorStop(1, new Intensity(1, 0, 0)), new ColorStop(0.5, new Intensity(0, 1, 0)), new ColorStop(0.5, new Intensity(0, 0, 1)));
        var texture = new RampTexture(s_u, ramp);
        Assert.Equal(new Intensity(0, 1, 0), texture.Sample(TextureLookup.At(0.4999, 0)));
        Assert.Equal(new Intensity(0, 0, 1), texture.Sample(TextureLookup.At(0.5, 0)));
        Assert.Equal(0.5f, texture.Sample(TextureLookup.At(0.75, 0)).R, 1e-5);
        Assert.Equal(new Intensity(1, 0, 0), texture.Sample(TextureLookup.At(7, 0)));
        Assert.Equal(new Intensity(0.25f, 0.5f, 0.25f), ramp.Mean);
    }

    [Fact]
    public void Constants_AreFolded()
    {
        Assert.Equal(TextureNeeds.None, new ProductTexture(s_u, s_black).Needs);
        Assert.Equal(TextureNeeds.None, new ProductTexture(s_blue, s_red).Needs);
        Assert.Equal(TextureNeeds.None, new MixTexture(s_red, s_u, 0).Needs);
        Assert.Equal(TextureNeeds.Coordinate, new MixTexture(s_red, s_u, 1).Needs);
        Assert.Equal(TextureNeeds.None, new SelectTexture(s_red, s_blue, s_u).Needs);
        Assert.Equal(TextureNeeds.None, new LayeredTexture(s_u, new TextureCover(s_red, new ConstantTexture(Intensity.White))).Needs);
        Assert.Equal(TextureNeeds.None, new TransformedTexture(s_red, Transform.Scaling(new Vector3D(2, 2, 2))).Needs);
        Assert.Equal(TextureNeeds.None, new TriplanarTexture(s_red).Needs);
        Assert.Equal(TextureNeeds.LocalPoint, new TriplanarTexture(s_u).Needs);
    }

    [Fact]
    public void Transformed_ScaleTwo_MakesThePatternTwiceAsLarge()
    {
        var marble = new MarbleTexture();
        var large = new TransformedTexture(marble, Transform.Scaling(new Vector3D(2, 2, 2)));
        Assert.Equal(marble.Sample(TextureLookup.At(new Point3D(0.1, 0.2, 0.3))), large.Sample(TextureLookup.At(new Point3D(0.2, 0.4, 0.6))));
    }

    [Fact]
    public void Transformed_World_ReadsTheWorldPoint()
    {
        var axis = new GradientTexture { Kind = GradientKind.Axis };
        var fixedInWorld = new TransformedTexture(axis) { Frame = TextureFrame.World };
        Assert.Equal(TextureNeeds.WorldPoint, fixedInWorld.Needs);
        Assert.Equal(0.75f, fixedInWorld.Sample(TextureLookup.At(new Point3D(0, 0.1, 0)) with { WorldPoint = new Point3D(0, 0.75, 0) }).R);
    }

    /// <summary>On the faces of a box, where one normal component is 1, triplanar is the box mapping.</summary>
    [Theory]
    [InlineData(1, 0, 0)]
    [InlineData(-1, 0, 0)]
    [InlineData(0, 1, 0)]
    [InlineData(0, -1, 0)]
    [InlineData(0, 0, 1)]
    [InlineData(0, 0, -1)]
    public void Triplanar_FacesOfABox_AreTheBoxMapping(double nx, double ny, double nz)
    {
        Vector3D normal = new(nx, ny, nz);
        Point3D p = new(nx == 0 ? 0.3 : nx, ny == 0 ? -0.6 : ny, nz == 0 ? 0.1 : nz);
        TextureCoordinate expected = new BoxMapping().Map(new SurfacePosition(p, normal, default));
        var show = new FunctionTexture(at => new Intensity((float)at.Coordinate.U, (float)at.Coordinate.V, 0), TextureNeeds.Coordinate);
        Assert.Equal(new Intensity((float)expected.U, (float)expected.V, 0), new TriplanarTexture(show).Sample(TextureLookup.At(p, normal)));
    }

    [Fact]
    public void Triplanar_Weights_AddUpToOne()
    {
        var white = new FunctionTexture(_ => Intensity.White, TextureNeeds.Coordinate);
        var random = new Random(8);
        for (int i = 0; i < 200; i++)
        {
            Vector3D n = new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5).Normalized();
            Assert.Equal(1, new TriplanarTexture(white) { Sharpness = 1 + (i % 64) }.Sample(TextureLookup.At(Point3D.Origin, n)).R, 1e-6);
        }
    }

    [Fact]
    public void Bake_Gradient_TexelsAreExactAndTheErrorIsThatOfTheSeam()
    {
        BakedTexture baked = BakedTexture.Bake(new GradientTexture { Kind = GradientKind.V }, 4, 8);
        Assert.Equal(Intensity.Grey(0.5f / 8), baked.Texture.ColorMap[2, 0]);
        Assert.Equal(Intensity.Grey(7.5f / 8), baked.Texture.ColorMap[0, 7]);
        Assert.Equal(32 * 16, baked.Places);

        // Repeated, the lookup falls from 15/16 to 1/16 over the last half texels: at their ends it is 7/16 + 1/2 away from the original.
        Assert.InRange(baked.LargestError, 0.375, 0.5);
        Assert.InRange(BakedTexture.Bake(new ConstantTexture(Intensity.White), 3, 3).RootMeanSquareError, 0, 1e-7);
    }

    [Fact]
    public void Bake_FinerPictures_HaveSmallerErrors()
    {
        var noise = new NoiseTexture { Frequency = 3, FilterWidth = 0 };
        double coarse = BakedTexture.Bake(noise, 16, 8, new BakeOptions { Surface = BakeSurfaces.Sphere }).RootMeanSquareError;
        double fine = BakedTexture.Bake(noise, 64, 32, new BakeOptions { Surface = BakeSurfaces.Sphere }).RootMeanSquareError;
        Assert.InRange(fine, 0, coarse / 4);
    }

    [Theory]
    [InlineData(0.125, 0.75)]
    [InlineData(0.9, 0.2)]
    public void BakeSurfaces_AreTheInversesOfTheMappings(double u, double v)
    {
        TextureCoordinate at = new(u, v);
        void Same(IMapping mapping, Func<TextureCoordinate, SurfacePosition> surface)
        {
            TextureCoordinate back = mapping.Map(surface(at));
            Assert.Equal(u, back.U, 1e-14);
            Assert.Equal(v, back.V, 1e-14);
        }

        Same(new SphericalMapping(), BakeSurfaces.Sphere);
        Same(new CylindricalMapping(), BakeSurfaces.Cylinder);
        Same(new RectangularMapping(), BakeSurfaces.Rectangle);
    }
}
