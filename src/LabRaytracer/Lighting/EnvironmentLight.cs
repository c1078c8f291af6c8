namespace LabRaytracer;

/// <summary>Light from all around (Polish: oświetlenie otoczeniem): every direction has the radiance of a texture, such as a lat-long picture of a sky.</summary>
/// <remarks>
/// <para>Immutable, thread safe as far as its texture is. With radiance L in the direction w, a matte surface has the brightness k_d / pi times the integral of L cos over
/// the directions that it sees: k_d L under an even sky. One sample stands for directional light of intensity L / (pi p samples), p being its density per steradian.</para>
/// <para>Samples are drawn in proportion to luminance x sin(theta) from a table of at most 1024 x 512 cells, made once a render and only for textured light.
/// The light of every pixel is right in the mean whatever the table; the more even L is inside of a cell, the less noise. Where the table cannot follow the texture
/// (3D and procedural textures, mappings other than the spherical one, transforms of (u, v)), 1/16 of the samples are drawn evenly.</para>
/// <para>A constant colour is added in closed form, k_d L: no samples, no shadows, no highlights. For shadows under an even sky use a picture of one texel.</para>
/// <para>The surroundings themselves are seen only if they are the scene's <c>Background</c> too.</para>
/// </remarks>
public sealed class EnvironmentLight : Light
{
    /// <summary>Creates light from all around.</summary>
    /// <param name="radiance">Linear radiance by direction; the default mapping is <see cref="SphericalMapping"/>, a lat-long picture.</param>
    public EnvironmentLight(TextureSlot radiance)
    {
        ArgumentNullException.ThrowIfNull(radiance);
        Radiance = radiance;
    }

    /// <summary>Linear radiance by direction. What comes out negative counts as 0 when samples are drawn.</summary>
    public TextureSlot Radiance { get; }

    /// <summary>Turns the surroundings about an axis through the origin. Default: not turned.</summary>
    /// <exception cref="ArgumentException">The transform moves, scales or mirrors.</exception>
    public Transform Rotation { get; init => field = LightChecks.Rotation(value); } = Transform.Identity;

    /// <summary>Samples at each point, [1, 4096]; powers of two fill the sky best. Default: 32. Their noise falls with the number, their time grows with it.</summary>
    /// <exception cref="ArgumentOutOfRangeException">Outside [1, 4096].</exception>
    public int Samples { get; init => field = LightChecks.Samples(value); } = 32;

    /// <inheritdoc/>
    public override int SampleCount => Samples;

    /// <summary>Its light has no single direction: never a sample. The renderer draws samples of its own.</summary>
    public override bool TrySample(Point3D point, out LightSample sample)
    {
        sample = default;
        return false;
    }
}
