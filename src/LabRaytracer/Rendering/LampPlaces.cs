namespace LabRaytracer;

/// <summary>Where on a lamp the samples of a group of hits lie.</summary>
internal sealed unsafe class LampPlaces<R, F, I>(PixelSampling sampling, int* pixels, LaneMemory memory, int capacity)
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const int MostDepths = 128;

    private readonly I* _first = memory.Column<I>(capacity, I.Width);
    private readonly I* _second = memory.Column<I>(capacity, I.Width);

    /// <summary>The places of the current sample.</summary>
    public SquareColumns<R> Columns { get; } = new(memory, capacity);

    /// <summary>Starts the samples of a lamp.</summary>
    /// <param name="lamp">Number of the lamp.</param>
    /// <param name="order">Numbers of the rays that hit, padded to whole groups of lanes.</param>
    /// <param name="packets">Groups of lanes.</param>
    /// <param name="samples">Samples of a hit.</param>
    public void Begin(int lamp, int* order, int packets, int samples)
    {
        int purpose = 1 + (lamp * MostDepths) + sampling.Depth;
        int* first = (int*)_first, second = (int*)_second;
        for (int i = 0; i < packets * R.Width; i++)
        {
            (first[i], second[i]) = sampling.Scramble(pixels[order[i]], purpose, samples);
        }
    }

    /// <summary>The place of one hit in units of 2^-32.</summary>
    /// <param name="hit">Number in the group.</param>
    /// <param name="point">Number of the point of the sequence.</param>
    public (uint S, uint T) Fraction(int hit, (uint S, uint T) point) => (point.S ^ (uint)((int*)_first)[hit], point.T ^ (uint)((int*)_second)[hit]);

    /// <summary>The point of the sequence that a sample scrambles.</summary>
    /// <param name="sample">Number of the sample of a hit.</param>
    public static (uint S, uint T) Point(int sample) => (SquareSequence.First((uint)sample), SquareSequence.Second((uint)sample));

    /// <summary>Writes the places of a sample of every hit.</summary>
    /// <param name="sample">Number of the sample of a hit.</param>
    /// <param name="packets">Groups of lanes.</param>
    public void Place(int sample, int packets)
    {
        (uint s, uint t) = Point(sample);
        I first = I.Of((int)s), second = I.Of((int)t);
        for (int packet = 0; packet < packets; packet++)
        {
            Columns.S[packet] = SquareSequence.Unit<R, F, I>(_first[packet] ^ first);
            Columns.T[packet] = SquareSequence.Unit<R, F, I>(_second[packet] ^ second);
        }
    }
}
