namespace LabRaytracer;

/// <summary>A texture that is a function of yours: the shortest way to a procedural texture.</summary>
/// <remarks>
/// <para><c>new FunctionTexture(at => Intensity.Grey((float)at.Coordinate.U))</c> is a gradient along u.</para>
/// <para>The function is called once for each hit, from several threads at once: it must not change anything, and should give the same colour for the same lookup.
/// Immutable and thread safe if the function is.</para>
/// </remarks>
public sealed class FunctionTexture : ITexture
{
    private readonly Func<TextureLookup, Intensity> _function;

    /// <summary>A texture by a function.</summary>
    /// <param name="function">Linear colour at a lookup.</param>
    /// <param name="needs">What the function reads of a lookup. Default: texture coordinates and local point.</param>
    /// <exception cref="ArgumentNullException">There is no function.</exception>
    public FunctionTexture(Func<TextureLookup, Intensity> function, TextureNeeds needs = TextureNeeds.Coordinate | TextureNeeds.LocalPoint)
    {
        _function = PropertyChecks.NotNull(function);
        Needs = needs;
    }

    /// <inheritdoc/>
    public TextureNeeds Needs { get; }

    /// <inheritdoc/>
    public Intensity Sample(in TextureLookup lookup) => _function(lookup);
}
