namespace LabRaytracer;

/// <summary>What a render did, and what it did not have to do.</summary>
/// <remarks>Counts are sums over all threads; stage times too, so that they add up to threads x wall time.</remarks>
public sealed class RenderStatistics
{
    /// <summary>Wall time of making the scene ready (textures decoded, shapes packed, trees built), seconds.</summary>
    public double PrepareSeconds { get; internal set; }

    /// <summary>Wall time of rendering proper, seconds.</summary>
    public double RenderSeconds { get; internal set; }

    /// <summary>Rays from the camera.</summary>
    public long PrimaryRays { get; internal set; }

    /// <summary>Pixels near edges of objects, which took more samples; 0 unless <see cref="RenderOptions.EdgeSamples"/> asks for them.</summary>
    public long EdgePixels { get; internal set; }

    /// <summary>Estimated root mean square error of the picture against its converged form, linear light, over all components; null without an error budget.</summary>
    public double? EstimatedRmse { get; internal set; }

    /// <summary>Reflected and refracted rays.</summary>
    public long SecondaryRays { get; internal set; }

    /// <summary>Visible hits: nearest hits of rays that are not shadow rays. The surface is computed once for each, and for nothing else.</summary>
    public long Hits { get; internal set; }

    /// <summary>
    /// Visible hits whose ray parameter the last, expensive digits changed: grazing hits, rays that start near the surface, and with <see cref="Precision.Exact"/>
    /// any other. Never more than <see cref="Hits"/>.
    /// </summary>
    public long HitsRefined { get; internal set; }

    /// <summary>Samples of lamps that have several (flat lamps, surroundings), one a hit and sample; each is a shadow ray that is followed or skipped.</summary>
    public long LampSamples { get; internal set; }

    /// <summary>Shadow rays followed.</summary>
    public long ShadowRays { get; internal set; }

    /// <summary>Shadow rays not followed because the surface faces away from the lamp, or no light arrives.</summary>
    public long ShadowRaysSkipped { get; internal set; }

    /// <summary>Reflected or refracted rays not followed because their weight cannot change the picture.</summary>
    public long SecondaryRaysSkipped { get; internal set; }

    /// <summary>Evaluations of mappings, one a hit and distinct mapping.</summary>
    public long Mappings { get; internal set; }

    /// <summary>Lookups of textures, one a hit and distinct texture.</summary>
    public long TextureLookups { get; internal set; }

    /// <summary>Looks at the opacity of a surface, by camera and shadow rays; 0 unless a material has one.</summary>
    public long AlphaTests { get; internal set; }

    /// <summary>Slot values that were constant, so that neither mapping nor texture was evaluated.</summary>
    public long ConstantSlots { get; internal set; }

    /// <summary>Pairs of a visible hit and a lamp that were not looked at because no lamp changes the hit's material.</summary>
    public long UnlitHits { get; internal set; }

    /// <summary>Textures that the scene uses, made ready.</summary>
    public int Textures { get; internal set; }

    /// <summary>Textures that the scene names and no pixel can show, so that their files were not opened.</summary>
    public int TexturesSkipped { get; internal set; }

    /// <summary>What was left out, and what it would have cost.</summary>
    public IReadOnlyList<SkippedWork> Skipped => SkippedWork.Of(this);

    /// <summary>Texture lookups whose footprint was more than 64 times as long as wide: the filter ewa made them too soft.</summary>
    public long FilterFallbacks { get; internal set; }

    /// <summary>Pixels that came out NaN or infinite and were set to black.</summary>
    public long NotFinitePixels { get; internal set; }

    /// <summary>The first such pixel in row order, or null.</summary>
    public (int X, int Y)? FirstNotFinitePixel { get; internal set; }

    /// <summary>Seconds by stage, summed over threads.</summary>
    public IReadOnlyDictionary<string, double> StageSeconds { get; internal set; } = new Dictionary<string, double>();

    /// <summary>Bytes of packed shapes and search trees.</summary>
    public long GeometryBytes { get; internal set; }

    /// <summary>Vector width that was used: floats computed at once.</summary>
    public int LaneWidth { get; internal set; }
}
