namespace LabRaytracer;

/// <summary>Textures of scene files.</summary>
internal static class TextureFormats
{
    private static readonly GridTexture s_grid = new();

    private static readonly Key<NamedFile> s_file = Key.Required(
        "file", new FileFormat("a picture", isPicture: true), "Path of a PNG, PPM, PGM, PFM, HDR or JPEG picture, relative to the folder of this file.");

    private static readonly Key<TextureFilter> s_filter = Key.Optional(
        "filter", ChoiceFormat.Of<TextureFilter>(), TextureFilter.Bilinear, "How a colour is made of the texels around a point.");

    private static readonly Key<TexelConvention> s_texels = Key.Optional(
        "texels", ChoiceFormat.Of<TexelConvention>(), TexelConvention.Center, "Where texels lie: at centres (i + 1/2) / W, or as nodes x = (W - 1) u as the lab sheet has it.");

    private static readonly Key<TextureWrap> s_wrapU = Key.Optional(
        "wrapU", ChoiceFormat.Of<TextureWrap>(), "What lies outside 0 to 1 in u. Default: as the mapping suggests.");

    private static readonly Key<TextureWrap> s_wrapV = Key.Optional(
        "wrapV", ChoiceFormat.Of<TextureWrap>(), "What lies outside 0 to 1 in v. Default: as the mapping suggests.");

    private static readonly Key<Intensity> s_borderColor = Key.Optional(
        "borderColor", Colors.Any, Intensity.Black, "What a wrap of \"border\" shows outside the picture, linear; alpha is 0 there, so that layers show what is below.");

    private static readonly Key<ColorSpace> s_colorSpace = Key.Optional(
        "colorSpace", ChoiceFormat.Of<ColorSpace>(), ColorSpace.Auto, "How numbers of the file become linear light; auto: what the file says for colours, as they are for data.");

    private static readonly Key<Intensity> s_color = Key.Required("color", Colors.Any, "The colour, linear.");

    private static readonly Key<Intensity> s_even = Key.Optional("even", Colors.Any, Intensity.White, "Colour of the cells whose numbers add up to an even number.");

    private static readonly Key<Intensity> s_odd = Key.Optional("odd", Colors.Any, Intensity.Black, "Colour of the other cells.");

    private static readonly Key<double> s_columns = Key.Optional(
        "columns", NumberFormat.Positive, 8, "Cells along u from 0 to 1; in local space along x and z in one unit.");

    private static readonly Key<double> s_rows = Key.Optional("rows", NumberFormat.Positive, 8, "Cells along v from 0 to 1; in local space along y in one unit.");

    private static readonly Key<CheckerSpace> s_space = Key.Optional(
        "space", ChoiceFormat.Of<CheckerSpace>(), CheckerSpace.Uv, "Where the cells lie: squares of texture space, or cubes of the object's own space.");

    private static readonly Key<double> s_lineWidth = Key.Optional("lineWidth", NumberFormat.Share, 0, "Width of lines between the cells of texture space, in cells.");

    private static readonly Key<Intensity> s_line = Key.Optional("line", Colors.Any, Intensity.Black, "Colour of the lines.");

    private static readonly Key<PatternFilter> s_patternFilter = Key.Optional(
        "filter", ChoiceFormat.Of<PatternFilter>(), PatternFilter.Nearest, "Colours of points, or means over what samples cover.");

    private static readonly Key<int> s_gridColumns = Key.Optional("columns", new IntegerFormat(2, 100), s_grid.Columns, "Cells along u from 0 to 1.");

    private static readonly Key<int> s_gridRows = Key.Optional("rows", new IntegerFormat(2, 100), s_grid.Rows, "Cells along v from 0 to 1.");

    private static readonly Key<double> s_gridLine = Key.Optional("lineWidth", NumberFormat.Share, s_grid.LineWidth, "Width of the lines between cells, in cells.");

    /// <summary>A texture, told by its type.</summary>
    public static VariantFormat<ITexture> Inline { get; } = new(
        "type",
        "A texture: a colour for every point of a surface.",
        [
            new("imageTexture", "A picture file.", [s_file, s_filter, s_texels, s_wrapU, s_wrapV, s_borderColor, s_colorSpace], Open, ("type", "image")),
            new("constantTexture", "The same colour everywhere.", [s_color], fields => new ConstantTexture(fields.Get(s_color)), ("type", "constant")),
            new("checkerTexture", "A checkerboard.", [s_even, s_odd, s_columns, s_rows, s_space, s_lineWidth, s_line, s_patternFilter], Checker, ("type", "checker")),
            new("gridTexture", "The numbered test grid of the lab sheet.", [s_gridColumns, s_gridRows, s_gridLine, s_patternFilter], Grid, ("type", "grid")),
        ],
        () => ProceduralFormats.All);

    /// <summary>Named textures.</summary>
    public static MapFormat<ITexture> Map { get; } = new(Inline, reading => reading.Textures);

    /// <summary>The name of a texture.</summary>
    public static NameFormat<ITexture> Name { get; } = new("texture", "textures", reading => reading.Textures);

    /// <summary>A texture by name or in place.</summary>
    public static EitherFormat<ITexture> Any { get; } = new("the name of a texture, or a texture { \"type\": ... }", (NodeKind.Text, Name), (NodeKind.Object, Inline)) { Name = "textureReference" };

    private static ITexture Open(Fields fields)
    {
        NamedFile file = fields.Get(s_file);
        Texture texture = fields.Reading.Folder.Open(file.Path, file.Node.Location).With(new SamplingOptions
        {
            Filter = fields.Get(s_filter),
            Texels = fields.Get(s_texels),
            WrapU = fields.Has(s_wrapU) ? fields.Get(s_wrapU) : null,
            WrapV = fields.Has(s_wrapV) ? fields.Get(s_wrapV) : null,
            BorderColor = fields.Get(s_borderColor),
            ColorSpace = fields.Get(s_colorSpace),
        });
        fields.Reading.Note(texture, file.Node);
        return texture;
    }

    private static CheckerTexture Checker(Fields fields) => new()
    {
        Even = fields.Get(s_even),
        Odd = fields.Get(s_odd),
        Columns = fields.Get(s_columns),
        Rows = fields.Get(s_rows),
        Space = fields.Get(s_space),
        LineWidth = fields.Get(s_lineWidth),
        Line = fields.Get(s_line),
        Filter = fields.Get(s_patternFilter),
    };

    private static GridTexture Grid(Fields fields) => new()
    {
        Columns = fields.Get(s_gridColumns), Rows = fields.Get(s_gridRows), LineWidth = fields.Get(s_gridLine), Filter = fields.Get(s_patternFilter),
    };
}
