namespace LabRaytracer;

/// <summary>Spreads camera rays over the lens.</summary>
/// <param name="camera">The camera, with a lens.</param>
/// <param name="sampling">Random numbers of the pixels.</param>
/// <param name="memory">Owns the columns.</param>
/// <param name="pixels">Pixels of a tile.</param>
internal sealed unsafe class LensStage<R, F, I>(Camera camera, PixelSampling sampling, LaneMemory memory, int pixels)
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const int Purpose = 0;

    private readonly I* _first = memory.Column<I>(pixels, I.Width);
    private readonly I* _second = memory.Column<I>(pixels, I.Width);
    private readonly SquareColumns<R> _places = new(memory, pixels);

    /// <summary>Moves each pixel's ray to its place on the lens.</summary>
    /// <param name="rays">Rays through the middle of the lens, one a pixel.</param>
    /// <param name="x">Horizontal positions on the picture, pixels.</param>
    /// <param name="y">Vertical positions on the picture, pixels.</param>
    /// <param name="options">Size of the picture.</param>
    public void Run(RayBatch<R, F, I> rays, R* x, R* y, RenderOptions options)
    {
        Place(rays.Packets);
        if (camera is IWideLensCamera wide)
        {
            wide.Spread(_places.S, _places.T, rays.Columns, rays.Packets);
            return;
        }

        for (int i = 0; i < rays.Count; i++)
        {
            SquarePoint place = new(R.Take(_places.S, i), R.Take(_places.T, i));
            rays.Set(i, camera.RayAt(R.Take(x, i), R.Take(y, i), place, options.Width, options.Height));
        }
    }

    private void Place(int packets)
    {
        for (int i = 0; i < packets * R.Width; i++)
        {
            (((int*)_first)[i], ((int*)_second)[i]) = sampling.Scramble(i, Purpose, 1);
        }

        for (int packet = 0; packet < packets; packet++)
        {
            _places.S[packet] = SquareSequence.Unit<R, F, I>(_first[packet]);
            _places.T[packet] = SquareSequence.Unit<R, F, I>(_second[packet]);
        }
    }
}
