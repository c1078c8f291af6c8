namespace LabRaytracer;

/// <summary>A picture as a texture (Polish: tekstura): the class of lab sheet IV, Program 1.</summary>
/// <remarks>
/// <para>A texture loaded from a file keeps its packed texels (4 bytes each for 8-bit files) and decodes the file when it is first needed.
/// <see cref="ColorMap"/> is a door onto them: its first read builds the array, which is the truth from then on.</para>
/// <para>Edits of <see cref="ColorMap"/> between renders count; during one, never. Rendering with a texture is thread safe, editing it is not.</para>
/// </remarks>
public sealed class Texture : IPreparedTexture
{
    private readonly TexelFile? _file;
    private readonly float[,]? _alphaMap;
    private Intensity[,]? _colorMap;
    private SamplingOptions _sampling = SamplingOptions.Default;

    /// <summary>Creates a black texture.</summary>
    /// <param name="width">Columns, [1, 1048576].</param>
    /// <param name="height">Rows, [1, 1048576].</param>
    /// <exception cref="ArgumentOutOfRangeException">A side is outside its range.</exception>
    public Texture(int width, int height)
    {
        CheckSide(width, nameof(width));
        CheckSide(height, nameof(height));
        _colorMap = new Intensity[width, height];
    }

    /// <summary>Creates a texture of an array, which it keeps: <c>colorMap[x, y]</c>, y up.</summary>
    /// <param name="colorMap">Linear colours; 1 to 1048576 columns and rows.</param>
    /// <exception cref="ArgumentOutOfRangeException">A side is outside its range.</exception>
    public Texture(Intensity[,] colorMap)
    {
        ArgumentNullException.ThrowIfNull(colorMap);
        CheckSide(colorMap.GetLength(0), nameof(colorMap));
        CheckSide(colorMap.GetLength(1), nameof(colorMap));
        _colorMap = colorMap;
    }

    /// <summary>Creates a texture of an array of colours and one of opacities, which it keeps: <c>[x, y]</c>, y up.</summary>
    /// <param name="colorMap">Linear colours, not multiplied by alpha; 1 to 1048576 columns and rows.</param>
    /// <param name="alphaMap">Alpha of each texel, [0, 1]: 0 is not there, 1 is opaque. As large as <paramref name="colorMap"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A side is outside its range.</exception>
    /// <exception cref="ArgumentException">The arrays differ in size.</exception>
    public Texture(Intensity[,] colorMap, float[,] alphaMap)
        : this(colorMap)
    {
        ArgumentNullException.ThrowIfNull(alphaMap);
        if (alphaMap.GetLength(0) != colorMap.GetLength(0) || alphaMap.GetLength(1) != colorMap.GetLength(1))
        {
            throw new ArgumentException(
                $"The alpha map has {alphaMap.GetLength(0)} x {alphaMap.GetLength(1)} texels; it must have {colorMap.GetLength(0)} x {colorMap.GetLength(1)} as the colour map.",
                nameof(alphaMap));
        }

        _alphaMap = alphaMap;
    }

    private Texture(TexelFile? file, Intensity[,]? colorMap, float[,]? alphaMap) => (_file, _colorMap, _alphaMap) = (file, colorMap, alphaMap);

    /// <summary>Number of columns.</summary>
    /// <exception cref="PictureFormatException">The file, read now for the first time, is not a picture.</exception>
    public int Width => _colorMap?.GetLength(0) ?? Texels.Width;

    /// <summary>Number of rows.</summary>
    /// <exception cref="PictureFormatException">The file, read now for the first time, is not a picture.</exception>
    public int Height => _colorMap?.GetLength(1) ?? Texels.Height;

    /// <summary>
    /// Linear colours of the texels: <c>ColorMap[x, y]</c>, x to the right in [0, Width), y up in [0, Height): [0, 0] is the bottom-left texel,
    /// so that the sheet's y_p = (v_res - 1) v holds as written.
    /// </summary>
    /// <remarks>The first read of a loaded texture builds the array; from its first edit on the array is what is rendered, in data slots too.</remarks>
    public Intensity[,] ColorMap => _colorMap ??= ColorMapTexels.Unpack(Texels, DecodeTable(Texels, isData: false));

    /// <summary>How the texture is looked up. Default: bilinear between texel centres, wrap as the mapping suggests.</summary>
    public SamplingOptions Sampling
    {
        get => _sampling;
        set => _sampling = value ?? throw new ArgumentNullException(nameof(value));
    }

    /// <summary>Where the picture came from, for messages; empty if not from a file.</summary>
    public string Path { get; private init; } = "";

    /// <summary>
    /// How the numbers of the file become light in colour slots, and by which rule: what <see cref="SamplingOptions.ColorSpace"/> asks for, then what the file says (of PNG: cICP,
    /// sRGB, then gAMA), then sRGB by assumption; such as "sRGB (gAMA chunk)".
    /// </summary>
    /// <exception cref="PictureFormatException">The file, read now for the first time, is not a picture.</exception>
    public string ColorRule => _file is null ? "linear (ColorMap)" : PictureSamplers.Rule(Texels, Sampling.ColorSpace);

    /// <summary>What the file's samples are if they have been decoded, without them; or null.</summary>
    internal PixelBuffer? Decoded => _file?.Decoded?.Facts;

    private TexelStore Texels => _file!.Texels(Sampling.Filter);

    /// <summary>A texture of a picture file, decoded when it is first needed.</summary>
    /// <param name="path">Path of a PNG, PPM, PGM, PFM, HDR (or, if a codec is there, JPEG or other) file.</param>
    /// <param name="limits">Limits of size; null for the defaults.</param>
    /// <exception cref="FileNotFoundException">There is no such file.</exception>
    public static Texture Load(string path, PictureLimits? limits = null)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        if (!File.Exists(path))
        {
            throw new FileNotFoundException($"There is no picture file '{path}'.", path);
        }

        return new Texture(new TexelFile(() => PictureCodecs.Default.Read(path, limits)), null, null) { Path = path };
    }

    /// <summary>A texture of a picture file, decoded when it is first needed; if that fails, a checker of magenta and black, 64 x 64 texels.</summary>
    /// <param name="path">Path of the file, which need not exist.</param>
    /// <param name="failed">Told why the file cannot be read, once, by the thread that first needs it.</param>
    /// <param name="limits">Limits of size; null for the defaults.</param>
    public static Texture LoadOrStandIn(string path, Action<Exception> failed, PictureLimits? limits = null)
    {
        ArgumentException.ThrowIfNullOrEmpty(path);
        ArgumentNullException.ThrowIfNull(failed);
        return new Texture(new TexelFile(() => StandInPicture.Read(path, limits, failed)), null, null) { Path = path };
    }

    /// <summary>A texture of a picture. Row 0 of a picture is its top, row 0 of <see cref="ColorMap"/> the bottom: this is the only place that turns them over.</summary>
    /// <param name="picture">Linear colours.</param>
    public static Texture FromPicture(Picture picture)
    {
        ArgumentNullException.ThrowIfNull(picture);
        Intensity[,] colorMap = new Intensity[picture.Width, picture.Height];
        for (int y = 0; y < picture.Height; y++)
        {
            Span<Intensity> row = picture.Row(picture.Height - 1 - y);
            for (int x = 0; x < row.Length; x++)
            {
                colorMap[x, y] = row[x];
            }
        }

        return new Texture(colorMap);
    }

    /// <summary>The same texels, looked up in another way: a file's texels and an array that is there already are shared, not copied.</summary>
    /// <param name="sampling">How.</param>
    public Texture With(SamplingOptions sampling)
    {
        ArgumentNullException.ThrowIfNull(sampling);
        return new Texture(_file, _colorMap, _alphaMap) { Sampling = sampling, Path = Path };
    }

    /// <summary>Tells whether parts of the texture are not there: the file or the array has alpha, or a wrap has a border.</summary>
    /// <exception cref="PictureFormatException">The file, read now for the first time, is not a picture.</exception>
    public bool HasAlpha =>
        Sampling.WrapU == TextureWrap.Border || Sampling.WrapV == TextureWrap.Border || _alphaMap is not null || (_file is not null && Texels.Facts.HasAlpha);

    /// <inheritdoc/>
    public TextureNeeds Needs => NeedsUnder(Sampling.Filter);

    /// <inheritdoc/>
    /// <remarks>
    /// With a footprint, the filters that read it make smaller versions of the picture first: once for a texture from a file, at each call for one with an array, whose edits they must see.
    /// </remarks>
    public Intensity Sample(in TextureLookup lookup) => Sample(lookup, TextureUse.Color);

    /// <inheritdoc/>
    public float Alpha(in TextureLookup lookup) => Sample(lookup, TextureUse.Alpha).R;

    TextureNeeds IPreparedTexture.NeedsUnder(TextureFilter? filter) => NeedsUnder(filter ?? Sampling.Filter);

    private static TextureNeeds NeedsUnder(TextureFilter filter) => filter is TextureFilter.Trilinear or TextureFilter.Ewa or TextureFilter.Area
        ? TextureNeeds.Coordinate | TextureNeeds.Footprint
        : TextureNeeds.Coordinate;

    private Intensity Sample(in TextureLookup lookup, TextureUse use)
    {
        if (!lookup.Footprint.IsPoint && (NeedsUnder(Sampling.Filter) & TextureNeeds.Footprint) != 0)
        {
            return ScalarSampler.Sample(((IPreparedTexture)this).Prepare(use, null), lookup);
        }

        TexelAxis across = new(Width, Sampling.WrapU ?? lookup.WrapU, Sampling.Texels);
        TexelAxis up = new(Height, Sampling.WrapV ?? lookup.WrapV, Sampling.Texels);
        Double1 u = new(lookup.Coordinate.U), v = new(lookup.Coordinate.V);
        if (Sampling.Filter == TextureFilter.Nearest)
        {
            Double1 off = across.Nearest<Double1, Float1, Int1>(u, out Int1 x) | up.Nearest<Double1, Float1, Int1>(v, out Int1 y);
            return Double1.Any(off) ? Outside(use) : Texel(x.Value, y.Value, use);
        }

        if (Sampling.Filter is TextureFilter.CatmullRom or TextureFilter.BSpline)
        {
            return Bicubic(across, up, u, v, use);
        }

        Double1 outside = across.Between<Double1, Float1, Int1>(u, out Int1 x0, out Int1 x1, out Float1 right) | up.Between<Double1, Float1, Int1>(v, out Int1 y0, out Int1 y1, out Float1 above);
        Intensity below = Between(Texel(x0.Value, y0.Value, use), Texel(x1.Value, y0.Value, use), right.Value);
        Intensity top = Between(Texel(x0.Value, y1.Value, use), Texel(x1.Value, y1.Value, use), right.Value);
        return Double1.Any(outside) ? Outside(use) : Between(below, top, above.Value);
    }

    TextureSampler IPreparedTexture.Prepare(TextureUse use, TextureFilter? filter) =>
        PictureSamplers.Create(IsAsLoaded() ? _file!.Texels(filter ?? Sampling.Filter) : ColorMapTexels.Pack(_colorMap!, AlphaAt), use, Sampling, filter ?? Sampling.Filter);

    TextureSampler IPreparedTexture.PrepareSlopes(TextureChannel channel, TextureWrap wrapU, TextureWrap wrapV, TextureFilter? filter)
    {
        TexelStore slopes = SlopePicture.Create(IsAsLoaded() ? Texels : ColorMapTexels.Pack(_colorMap!, AlphaAt), channel, Sampling, wrapU, wrapV);
        return PictureSamplers.Create(slopes, TextureUse.Data, Sampling, filter ?? Sampling.Filter);
    }

    /// <summary>
    /// Tells whether the file's texels are the truth: nobody read the array, or nobody changed it since. So a mere look at <see cref="ColorMap"/>
    /// costs no memory in a render, and a data slot still gets the file's numbers.
    /// </summary>
    private bool IsAsLoaded()
    {
        if (_colorMap is null || _file is null)
        {
            return _colorMap is null;
        }

        ReadOnlySpan<float> table = DecodeTable(Texels, isData: false);
        for (int x = 0; x < Width; x++)
        {
            for (int y = 0; y < Height; y++)
            {
                if (_colorMap[x, y] != Texels.Color(table, x, y))
                {
                    return false;
                }
            }
        }

        return true;
    }

    /// <summary>Linear light of every code of a store in this texture's colour space.</summary>
    private ReadOnlySpan<float> DecodeTable(TexelStore store, bool isData) => PictureSamplers.DecodeTable(store, isData, Sampling.ColorSpace);

    private Intensity Texel(int x, int y, TextureUse use) => use == TextureUse.Alpha
        ? Intensity.Grey(AlphaAt(x, y))
        : _colorMap?[x, y] ?? Texels.Color(DecodeTable(Texels, isData: false), x, y);

    private float AlphaAt(int x, int y) => _alphaMap is not null ? _alphaMap[x, y] : _file is null ? 1 : Texels.Alpha(x, y);

    /// <summary>What lies beyond a border; nothing is there of the alpha.</summary>
    private Intensity Outside(TextureUse use) => use == TextureUse.Alpha ? Intensity.Black : Sampling.BorderColor;

    /// <summary>The mean of 4 x 4 texels; in colour slots.</summary>
    private Intensity Bicubic(in TexelAxis across, in TexelAxis up, Double1 u, Double1 v, TextureUse use)
    {
        Double1 outside = across.Around(u, Sampling.Filter, out CubicTaps<Float1, Int1> columns) | up.Around(v, Sampling.Filter, out CubicTaps<Float1, Int1> rows);
        ScalarTexelReader reader = new((x, y) => Texel(x, y, use), Width, Height);
        BicubicKernel<ScalarTexelReader> kernel = new(reader, reader.Start, Width, BicubicKernel<ScalarTexelReader>.Bounds(Sampling.Filter, isData: false));
        kernel.Mean(columns, rows, out CubicColor<Float1> mean);
        return Double1.Any(outside) ? Outside(use) : new Intensity(mean.R.Value, mean.G.Value, mean.B.Value);
    }

    private static Intensity Between(Intensity a, Intensity b, float weight) => new(
        MathF.FusedMultiplyAdd(weight, b.R - a.R, a.R),
        MathF.FusedMultiplyAdd(weight, b.G - a.G, a.G),
        MathF.FusedMultiplyAdd(weight, b.B - a.B, a.B));

    private static void CheckSide(int side, string name)
    {
        if (side is < 1 or > 1 << 20)
        {
            throw new ArgumentOutOfRangeException(name, side, "The sides of a texture must be in [1, 1048576] texels.");
        }
    }
}
