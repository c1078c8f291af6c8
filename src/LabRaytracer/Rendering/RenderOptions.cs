namespace LabRaytracer;

/// <summary>How a scene is rendered.</summary>
/// <remarks>Immutable, thread safe. Setters throw <see cref="ArgumentOutOfRangeException"/> outside the stated ranges.</remarks>
public sealed class RenderOptions
{
    /// <summary>Largest width and height of a picture, pixels.</summary>
    public const int MaxSide = 1 << 20;

    private readonly int _width = 1280;
    private readonly int _height = 720;
    private readonly int _samples = 1;
    private readonly int _threads = Environment.ProcessorCount;
    private readonly int _maxDepth = 5;
    private readonly int _maxSamples = 256;
    private readonly int _edgeSamples = 1;

    /// <summary>Width of the whole picture, pixels, [1, 1048576]. Default: 1280.</summary>
    public int Width
    {
        get => _width;
        init => _width = InRange(value, 1, MaxSide);
    }

    /// <summary>Height of the whole picture, pixels, [1, 1048576]. Default: 720.</summary>
    public int Height
    {
        get => _height;
        init => _height = InRange(value, 1, MaxSide);
    }

    /// <summary>Samples a pixel, a square number: 1, 4, 9, ... 65536. Default: 1.</summary>
    public int Samples
    {
        get => _samples;
        init
        {
            int side = (int)Math.Round(Math.Sqrt(Math.Max(0, value)));
            _samples = value is >= 1 and <= 65536 && side * side == value
                ? value
                : throw new ArgumentOutOfRangeException(nameof(value), value, "The number of samples must be a square: 1, 4, 9, 16, 25, ... up to 65536.");
        }
    }

    /// <summary>Where the samples of a pixel lie. Default: regular.</summary>
    public SamplePattern Pattern { get; init => field = PropertyChecks.Known(value); }

    /// <summary>How the light around a pixel's centre is weighted. Default: box.</summary>
    public PixelFilter PixelFilter { get; init => field = PropertyChecks.Known(value); }

    /// <summary>
    /// Root mean square error, of linear light over all components, that the picture may have, [0, 1000]; 0 (default): none, every pixel takes <see cref="Samples"/>.
    /// </summary>
    /// <remarks>
    /// Above 0, each pixel takes 4 samples (16 with Mitchell's filter), or as many more as <see cref="Samples"/> asks for; then, in each tile of 32 x 32 pixels, the samples of those with
    /// the largest errors are doubled until the tile's estimated error is below the budget or no pixel may take more than <see cref="MaxSamples"/>.
    /// Samples then follow Sobol's sequence, whatever the pattern. Views that show no light do without a budget.
    /// </remarks>
    public double ErrorBudget
    {
        get;
        init => field = value is >= 0 and <= 1000
            ? value
            : throw new ArgumentOutOfRangeException(nameof(value), value, "The error budget must be in [0, 1000], linear light; 0 is none, 0.01 is fine, 0.001 hardly visible.");
    }

    /// <summary>Most samples of a pixel under an error budget, [4, 65536]. Default: 256.</summary>
    public int MaxSamples
    {
        get => _maxSamples;
        init => _maxSamples = InRange(value, 4, 65536);
    }

    /// <summary>Samples of the pixels that edges of objects pass through, [1, 65536], where that is more than <see cref="Samples"/>. Default: 1, as many as the others.</summary>
    /// <remarks>
    /// <para>An edge is where another object begins, where one hides parts of itself (its distance jumps by about 1/32 or more), or where its surface turns by more than 11.5 degrees over a pixel:
    /// smooth silhouettes for little time, where textures are filtered and need one sample. The corners of all pixels are looked at: what fits between them, such as a wire, may be missed.
    /// Shadows, highlights and what mirrors and lenses show have no edges in this sense: <see cref="ErrorBudget"/> finds those.</para>
    /// <para>The samples follow Sobol's sequence, whatever the pattern: powers of two are best. No effect under an error budget, and in views that show no light.</para>
    /// </remarks>
    public int EdgeSamples
    {
        get => _edgeSamples;
        init => _edgeSamples = InRange(value, 1, 65536);
    }

    /// <summary>Number that random choices derive from, together with pixel and sample. Default: 0.</summary>
    public int Seed { get; init; }

    /// <summary>Threads, [1, 1024]. Default: as many as processors. The picture does not depend on it.</summary>
    public int Threads
    {
        get => _threads;
        init => _threads = InRange(value, 1, 1024);
    }

    /// <summary>Precision of geometry. Default: double.</summary>
    public Precision Precision { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Most reflections and refractions in a row, [0, 64]; what lies deeper is black. Default: 5.</summary>
    public int MaxDepth
    {
        get => _maxDepth;
        init => _maxDepth = InRange(value, 0, 64);
    }

    /// <summary>Filter of all picture textures, overriding their own; null (default): their own.</summary>
    public TextureFilter? Filter { get; init => field = value is { } filter ? PropertyChecks.Known(filter) : null; }

    /// <summary>What the picture shows. Default: colour.</summary>
    public RenderView View { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Part of the picture to render, inside it; null (default): all. The result has the size of this part.</summary>
    public PixelRectangle? Crop { get; init; }

    /// <summary>Whether work that cannot change the picture is left out. Default: it is.</summary>
    public Skipping Skipping { get; init => field = PropertyChecks.Known(value); }

    /// <summary>Whether work is left out; always in pictures of something else than colour.</summary>
    internal bool IsSkipping => Skipping == Skipping.On || !ViewStage.IsColor(View);

    /// <summary>Whether the number of samples depends on the error.</summary>
    internal bool HasBudget => ErrorBudget > 0 && ViewStage.IsColor(View);

    /// <summary>Whether pixels at edges take more samples than the others.</summary>
    internal bool HasEdges => EdgeSamples > Samples && !HasBudget && ViewStage.IsColor(View);

    /// <summary>Samples that every pixel takes: under an error budget 4, 8, 16, ...</summary>
    internal int FirstSamples
    {
        get
        {
            // Few samples say little about a filter that is negative in places: 8 of 100 count negatively.
            int samples = PixelFilter == PixelFilter.Mitchell ? Math.Min(4 * PixelEstimates.Fewest, MaxSamples) : PixelEstimates.Fewest;
            while (samples < Samples && 2 * samples <= MaxSamples)
            {
                samples *= 2;
            }

            return HasBudget ? samples : Samples;
        }
    }

    private static int InRange(int value, int min, int max) => value >= min && value <= max
        ? value
        : throw new ArgumentOutOfRangeException(nameof(value), value, $"Allowed: {min} to {max}.");
}
