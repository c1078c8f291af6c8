namespace LabRaytracer.Tests.Materials;

/// <summary>Textures modulate coefficients: k' = lerp(k, blend(k, T), amount), lab sheet IV, section 1.1.</summary>
public sealed unsafe class SlotTests
{
    private static readonly Intensity s_value = new(0.8f, 0.5f, 3), s_texel = new(0.3f, 1.7f, 0.1f);

    [Theory]
    [InlineData(BlendMode.Multiply, 0.4f)]
    [InlineData(BlendMode.Replace, 0.5f)]
    [InlineData(BlendMode.Add, 1.3f)]
    [InlineData(BlendMode.Mix, 0.65f)]
    public void Apply_Blend_IsTheFormula(BlendMode blend, float expected)
    {
        TextureSlot Slot(float amount) => new() { Value = Intensity.Grey(0.8f), Blend = blend, Amount = amount };
        Assert.Equal(expected, Slot(1).Apply(Intensity.Grey(0.5f)).G, 7);
        Assert.Equal(0.8f, Slot(0).Apply(Intensity.Grey(0.5f)).G);
        Assert.Equal((0.8f + expected) / 2, Slot(0.5f).Apply(Intensity.Grey(0.5f)).G, 7);
        Assert.Equal(expected, new ScalarSlot { Value = 0.8f, Blend = blend }.Apply(Intensity.Grey(0.5f)), 6);
    }

    [Fact]
    public void CompiledSlots_EveryBlendAndAmount_SameBitsAsApply()
    {
        foreach (BlendMode blend in Enum.GetValues<BlendMode>())
        {
            foreach (float amount in new[] { 0.1f, 0.5f, 1 })
            {
                TextureSlot slot = new() { Value = s_value, Blend = blend, Amount = amount };
                Intensity expected = slot.Apply(s_texel);
                Assert.Equal(expected, Read<Float1>(slot));
                Assert.Equal(expected, Read<Float4>(slot));
                Assert.Equal(expected, Read<Float8>(slot));
                Assert.Equal(expected, Read<Float16>(slot));
                foreach (TextureChannel channel in Enum.GetValues<TextureChannel>())
                {
                    ScalarSlot scalar = new() { Value = 0.7f, Blend = blend, Amount = amount, Channel = channel };
                    Assert.Equal(scalar.Apply(s_texel), Read<Float1>(scalar));
                    Assert.Equal(scalar.Apply(s_texel), Read<Float16>(scalar));
                }
            }
        }
    }

    [Fact]
    public void Material_ConstantTextures_AreFolded()
    {
        CompiledMaterial compiled = Compile(new Material
        {
            Diffuse = new TextureSlot { Texture = new ConstantTexture(s_texel), Value = s_value },
            Shininess = new ScalarSlot { Texture = new ConstantTexture(Intensity.Grey(0.5f)), Value = 100, Channel = TextureChannel.Red },
            Specular = Intensity.White,
        });
        Assert.Empty(compiled.Lookups);
        Assert.Equal(new CompiledSlot(s_value * s_texel, -1, BlendMode.Multiply, 1), compiled.Diffuse);
        Assert.Equal(50, compiled.Shininess.Value);
        Assert.Equal(8, compiled.ConstantSlots);
        Assert.Equal(SurfaceNeeds.None, compiled.Needs);
    }

    [Fact]
    public void Material_WhatABlackFactorHides_IsNotCompiled()
    {
        Texture texture = Rendering.TestScenes.Random(2, 2);
        Assert.Empty(Compile(new Material { Diffuse = new TextureSlot { Texture = texture, Value = Intensity.Black } }).Lookups);
        Assert.Empty(Compile(new Material { Diffuse = new TextureSlot { Texture = texture, Amount = 0 } }).Lookups);
        Assert.Empty(Compile(new Material { Shininess = new ScalarSlot { Texture = texture } }).Lookups);
        Assert.Empty(Compile(new Material { IndexOfRefraction = new ScalarSlot { Texture = texture } }).Lookups);
        Assert.Single(Compile(new Material { Diffuse = new TextureSlot { Texture = texture, Value = Intensity.Black, Blend = BlendMode.Add } }).Lookups);
    }

    [Fact]
    public void Material_SharedTexturesAndMappings_AreComputedOnce()
    {
        Texture first = Rendering.TestScenes.Random(2, 2), second = Rendering.TestScenes.Random(2, 2, 5);
        UvTransform twice = new(default, 0, new TextureCoordinate(2, 2), default);
        CompiledMaterial compiled = Compile(new Material
        {
            Diffuse = first,
            Emission = first,
            Reflection = second,
            Transparency = new TextureSlot { Texture = first, Transform = twice },
        });
        Assert.Equal((3, 2), (compiled.Lookups.Count, compiled.Coordinates.Count));
        Assert.Equal(compiled.Diffuse.Lookup, compiled.Emission.Lookup);
    }

    [Fact]
    public void Slots_OutsideTheirRanges_AreRefused()
    {
        ArgumentOutOfRangeException failure = Assert.Throws<ArgumentOutOfRangeException>(() => new TextureSlot { Amount = 1.1f });
        Assert.Contains("The amount of a texture must be in [0, 1].", failure.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => new TextureSlot { Amount = float.NaN });
        Assert.Throws<ArgumentOutOfRangeException>(() => new TextureSlot { Blend = (BlendMode)4 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new ScalarSlot { Value = float.PositiveInfinity });
        Assert.Throws<ArgumentOutOfRangeException>(() => new ScalarSlot { Amount = -0.1f });
        Assert.Throws<ArgumentNullException>(() => TextureSlot.Of(null!));
    }

    private static CompiledMaterial Compile(Material material) => new(material, new SphericalMapping(), new TexturePreparation(null));

    private static Intensity Read<F>(TextureSlot slot)
        where F : unmanaged, IReal<F>
    {
        F red = F.Of(s_texel.R), green = F.Of(s_texel.G), blue = F.Of(s_texel.B);
        CompiledSlot compiled = new(slot.Value, 0, slot.Blend, slot.Amount);
        compiled.Read([new ColorColumns<F> { R = &red, G = &green, B = &blue }], 0, out F r, out F g, out F b);
        return new Intensity((float)F.Get(r, F.Width - 1), (float)F.Get(g, F.Width - 1), (float)F.Get(b, F.Width - 1));
    }

    private static float Read<F>(ScalarSlot slot)
        where F : unmanaged, IReal<F>
    {
        F red = F.Of(s_texel.R), green = F.Of(s_texel.G), blue = F.Of(s_texel.B);
        CompiledScalar compiled = new(slot, slot.Value, 0);
        return (float)F.Get(compiled.Read([new ColorColumns<F> { R = &red, G = &green, B = &blue }], 0), F.Width - 1);
    }
}
