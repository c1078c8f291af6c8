namespace LabRaytracer;

/// <content>Pixels at edges of objects, which take more samples than the others.</content>
internal sealed unsafe partial class TileWorker<R, F, I>
{
    private readonly EdgeMarks? _edges;
    private readonly PixelEstimates? _edgeSums;
    private readonly SamplePlaces? _edgePlaces;

    /// <summary>Samples the pixels at edges again.</summary>
    private void SampleEdges(EdgeMarks edges, PixelEstimates sums, int x, int y)
    {
        FindEdges(edges, x, y);
        int width = Math.Min(Side, _area.X + _area.Width - x), height = Math.Min(Side, _area.Y + _area.Height - y), samples = _options.EdgeSamples;
        SlotRun run = new(sums, _edgePlaces!, x, y, samples);
        sums.Start(width, height, samples);
        for (int i = 0; i < Pixels; i++)
        {
            (int px, int py) = Place(i);
            bool isEdge = px < width && py < height && edges.IsEdge(px, py);
            for (int sample = 0; isEdge && sample < samples; sample++)
            {
                AddSlot(run, new PixelSlot(px, py, sample));
            }
        }

        TraceSlots(run);
        for (int i = 0; i < Pixels; i++)
        {
            (int px, int py) = Place(i);
            if (px < width && py < height && sums.Count(px, py) > 0)
            {
                _colors.SetSum(i, sums.Mean(px, py));
                Counters.PrimaryRays += samples;
                Counters.EdgePixels++;
            }
        }
    }

    /// <summary>Looks at the corners of all pixels; through the middle of a lens.</summary>
    private void FindEdges(EdgeMarks edges, int x, int y)
    {
        for (int first = 0; first < edges.Count; first += Pixels)
        {
            _rays.Count = Math.Min(Pixels, edges.Count - first);
            _rays.Bounds = null;
            _grid = null;
            for (int i = 0; i < _rays.Count; i++)
            {
                (int px, int py) = edges.Place(first + i);
                R.Put(_sampleX, i, x + px);
                R.Put(_sampleY, i, y + py);
                R.Put(_rays.Limit, i, double.PositiveInfinity);
            }

            AimRays();
            _rays.PadTail();
            _originPackets = 0;
            Counters.Charge(RenderStage.Camera);
            _tracer.Look(_rays, edges, first);
        }

        edges.Compare();
    }
}
