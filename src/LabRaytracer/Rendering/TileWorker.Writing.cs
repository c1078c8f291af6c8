namespace LabRaytracer;

/// <content>From means to the pixels of the picture.</content>
internal sealed unsafe partial class TileWorker<R, F, I>
{
    /// <summary>Means of the samples into the picture; what is not finite is counted and set to black.</summary>
    private void Write(int x, int y, Picture picture, int top)
    {
        int width = Math.Min(Side, _area.X + _area.Width - x), height = Math.Min(Side, _area.Y + _area.Height - y);
        bool isPlain = _colors.IsFinite && _options.View != RenderView.Nan;
        for (int first = 0; first < height; first += Block)
        {
            WriteBlocks(first, Math.Min(Block, height - first), width, picture, x - _area.X, y - top);
        }

        bool isMarked = _tracer.Tally is not null || _options.View == RenderView.Samples || _seams is not null;
        for (int row = 0; row < height && !(isPlain && !isMarked); row++)
        {
            Span<Intensity> pixels = picture.Row(y - top + row).Slice(x - _area.X, width);
            for (int column = 0; !isPlain && column < width; column++)
            {
                pixels[column] = Checked(pixels[column], x + column, y + row);
            }

            MarkRow(row, pixels);
        }
    }

    /// <summary>One row of blocks of pixels into the picture.</summary>
    /// <param name="first">The first row of pixels, of the tile.</param>
    /// <param name="rows">Rows of pixels that the picture has.</param>
    /// <param name="width">Columns of pixels that the picture has.</param>
    /// <param name="picture">The picture.</param>
    /// <param name="left">Column of the picture where the tile starts.</param>
    /// <param name="top">Row of the picture where the tile starts.</param>
    private void WriteBlocks(int first, int rows, int width, Picture picture, int left, int top)
    {
        fixed (Intensity* pixels = picture.Pixels)
        {
            Intensity* line = pixels + ((nint)(top + first) * picture.Width) + left;
            for (int column = 0; column < width; column += Block)
            {
                int number = Number(column, first), columns = Math.Min(Block, width - column);
                for (int row = 0; row < rows; row++)
                {
                    _colors.Copy(number + (row * Block), line + ((nint)row * picture.Width) + column, columns);
                }
            }
        }
    }

    /// <summary>Views that show more of a pixel than its light.</summary>
    private void MarkRow(int row, Span<Intensity> pixels)
    {
        for (int column = 0; _tracer.Tally is { } tally && column < pixels.Length; column++)
        {
            pixels[column] = tally.Color(Number(column, row), _options.Samples);
        }

        for (int column = 0; _options.View == RenderView.Samples && column < pixels.Length; column++)
        {
            int samples = _estimates?.Count(column, row) ?? _options.Samples, atEdges = _edgeSums?.Count(column, row) ?? 0;
            pixels[column] = SampleHeat.Color(Math.Max(samples, atEdges));
        }

        for (int column = 0; _seams is { } seams && column < pixels.Length; column++)
        {
            pixels[column] = seams.IsSeam(Number(column, row), HitBatch<R, F, I>.Miss) ? new Intensity(1, 0, 0) : Dim(pixels[column]);
        }
    }

    /// <summary>Looks at the pixels' centres and their neighbours' ones, if the view asks for it.</summary>
    private void FindSeams(int x, int y)
    {
        for (int place = 0; _seams is { } seams && place < SeamMarks.Places.Count; place++)
        {
            (int dx, int dy) = SeamMarks.Places[place];
            PlaceSamples(x + dx, y + dy, 0.5, 0.5);
            AimSamples(x, y);
            _tracer.Probe(_rays, seams.Objects(place), seams.U(place));
        }
    }

    private static Intensity Dim(Intensity color) => Intensity.Grey(0.25f * Math.Clamp(color.Luminance, 0, 1));

    /// <summary>A colour that is safe to leave the renderer; what is not finite is counted.</summary>
    private Intensity Checked(Intensity color, int x, int y)
    {
        bool isFinite = color.IsFinite;
        if (!isFinite)
        {
            Counters.Report(x, y);
        }

        return _options.View != RenderView.Nan ? (isFinite ? color : Intensity.Black)
            : isFinite ? Dim(color)
            : new Intensity(1, 0, 1);
    }
}
