using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Columns of rays in world space.</summary>
/// <remarks>A ray whose limit is below 0 is off: nothing hits it.</remarks>
internal sealed unsafe class RayBatch<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Origin, world space.</summary>
    public readonly R* OriginX, OriginY, OriginZ;

    /// <summary>Direction, world space, length 1.</summary>
    public readonly R* DirectionX, DirectionY, DirectionZ;

    /// <summary>Largest distance of interest, excluded; below 0 for a ray that is off or (shadow rays) blocked.</summary>
    public readonly R* Limit;

    /// <summary>Number of the object whose outer side the ray leaves, or -1.</summary>
    public readonly I* Source;

    /// <summary>Shadow rays that have a <see cref="Source"/>: number of its part.</summary>
    public readonly I* SourcePart;

    /// <summary>Groups of lanes in a bundle.</summary>
    public const int BundlePackets = 32;

    /// <summary>The same origins and directions rounded to float, for quick looks; written by <see cref="Narrow(int, int)"/>. In float lanes the rays themselves.</summary>
    private readonly F* _originX, _originY, _originZ, _directionX, _directionY, _directionZ;

    /// <summary>Bundle by bundle, what of the rounded copies is up to date.</summary>
    private readonly Narrowed[] _narrowed;
    private readonly DifferentialColumns<F> _differentials;
    private PinholeSteps? _pinhole;
    private bool _isDifferentiated;

    /// <param name="memory">Owns the columns.</param>
    /// <param name="capacity">Most rays.</param>
    /// <param name="hasDifferentials">Whether the rays carry differentials.</param>
    /// <param name="directions">Columns of directions that somebody else owns and writes; null for new ones.</param>
    public RayBatch(LaneMemory memory, int capacity, bool hasDifferentials = false, VectorColumns<R>? directions = null)
    {
        Capacity = capacity;
        _narrowed = new Narrowed[(capacity / R.Width / BundlePackets) + 1];
        HasDifferentials = hasDifferentials;
        _differentials = hasDifferentials ? new DifferentialColumns<F>(memory, capacity) : default;
        OriginX = memory.Column<R>(capacity, R.Width);
        OriginY = memory.Column<R>(capacity, R.Width);
        OriginZ = memory.Column<R>(capacity, R.Width);
        VectorColumns<R> aim = directions ?? new VectorColumns<R>(memory, capacity);
        DirectionX = aim.X;
        DirectionY = aim.Y;
        DirectionZ = aim.Z;
        Limit = memory.Column<R>(capacity, R.Width);
        Source = memory.Column<I>(capacity, I.Width);
        SourcePart = memory.Column<I>(capacity, I.Width);
        new Span<int>(Source, (capacity + I.Width - 1) / I.Width * I.Width).Fill(-1);
        _originX = R.IsSingle ? (F*)OriginX : memory.Column<F>(capacity, R.Width);
        _originY = R.IsSingle ? (F*)OriginY : memory.Column<F>(capacity, R.Width);
        _originZ = R.IsSingle ? (F*)OriginZ : memory.Column<F>(capacity, R.Width);
        _directionX = R.IsSingle ? (F*)DirectionX : memory.Column<F>(capacity, R.Width);
        _directionY = R.IsSingle ? (F*)DirectionY : memory.Column<F>(capacity, R.Width);
        _directionZ = R.IsSingle ? (F*)DirectionZ : memory.Column<F>(capacity, R.Width);
    }

    /// <summary>Shadow rays only: number of the object whose outer side all rays leave, or -1.</summary>
    public int CommonSource { get; set; } = -1;

    /// <summary>Bounds of each bundle of groups of lanes, by whoever makes rays of which he knows them; null where nobody does.</summary>
    public RayBounds[]? Bounds { get; set; }

    /// <summary>Tells whether the rays carry differentials.</summary>
    public bool HasDifferentials { get; }

    /// <summary>Where all rays come from a pinhole camera: how they change from one sample to the next; null for other rays.</summary>
    /// <remarks>Set once the rays are; their <see cref="Differentials"/> are written the first time that somebody asks for them.</remarks>
    public PinholeSteps? Pinhole
    {
        get => _pinhole;
        set
        {
            _pinhole = value;
            _isDifferentiated = value is null;
        }
    }

    /// <summary>Changes of the rays from one sample to the next ones; only there if some texture is filtered.</summary>
    public DifferentialColumns<F> Differentials
    {
        get
        {
            if (_pinhole is { } pinhole && !_isDifferentiated)
            {
                _isDifferentiated = true;
                NarrowDirections(0, Packets);
                pinhole.Write(SingleDirections, _differentials, Packets);
            }

            return _differentials;
        }
    }

    /// <summary>Directions rounded to float; written by <see cref="NarrowDirections"/>.</summary>
    public VectorColumns<F> SingleDirections => new(_directionX, _directionY, _directionZ);

    /// <summary>Most rays.</summary>
    public int Capacity { get; }

    /// <summary>Number of rays.</summary>
    public int Count { get; set; }

    /// <summary>The columns that cameras write.</summary>
    public RayColumns<R> Columns => new()
    {
        OriginX = OriginX, OriginY = OriginY, OriginZ = OriginZ, DirectionX = DirectionX, DirectionY = DirectionY, DirectionZ = DirectionZ,
    };

    /// <summary>Number of groups of lanes that hold them.</summary>
    public int Packets => (Count + R.Width - 1) / R.Width;

    /// <summary>The rays of one group of lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RayLanes<R> Load(int packet) => new(
        OriginX[packet], OriginY[packet], OriginZ[packet], DirectionX[packet], DirectionY[packet], DirectionZ[packet]);

    /// <summary>The rays of one group of lanes, rounded to float.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RayLanes<F> LoadSingle(int packet) => new(
        _originX[packet], _originY[packet], _originZ[packet], _directionX[packet], _directionY[packet], _directionZ[packet]);

    /// <summary>The parts of an object that shadow rays of one group of lanes leave, or -1.</summary>
    /// <param name="packet">Which group.</param>
    /// <param name="number">Number of the object.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public I SourceIn(int packet, int number) => I.Select(I.Equal(Source[packet], I.Of(number)), SourcePart[packet], I.Of(-1));

    /// <summary>Tells that rays have been set: rounded copies are not up to date, and are written by whoever reads them.</summary>
    public void Renew() => Array.Clear(_narrowed);

    /// <summary>Writes the rounded copies of all rays; called once all rays are set, before they are traced.</summary>
    public void Narrow()
    {
        Renew();
        Narrow(0, Packets);
    }

    /// <summary>Writes the rounded copies of the bundles that some groups of lanes lie in, unless they are up to date.</summary>
    /// <param name="first">First group of lanes.</param>
    /// <param name="end">Group of lanes after the last one.</param>
    public void Narrow(int first, int end)
    {
        NarrowDirections(first, end);
        for (int bundle = first / BundlePackets; !R.IsSingle && bundle * BundlePackets < end; bundle++)
        {
            if (_narrowed[bundle] != Narrowed.All)
            {
                _narrowed[bundle] = Narrowed.All;
                int from = bundle * BundlePackets, to = Math.Min((bundle + 1) * BundlePackets, Packets);
                Narrow(OriginX, OriginY, OriginZ, new(_originX, _originY, _originZ), from, to);
            }
        }
    }

    /// <summary>The same of directions alone.</summary>
    /// <param name="first">First group of lanes.</param>
    /// <param name="end">Group of lanes after the last one.</param>
    public void NarrowDirections(int first, int end)
    {
        for (int bundle = first / BundlePackets; !R.IsSingle && bundle * BundlePackets < end; bundle++)
        {
            if (_narrowed[bundle] == Narrowed.Nothing)
            {
                _narrowed[bundle] = Narrowed.Directions;
                int from = bundle * BundlePackets, to = Math.Min((bundle + 1) * BundlePackets, Packets);
                Narrow(DirectionX, DirectionY, DirectionZ, SingleDirections, from, to);
            }
        }
    }

    private static void Narrow(R* x, R* y, R* z, VectorColumns<F> to, int first, int end)
    {
        for (int packet = first; packet < end; packet++)
        {
            to.X[packet] = R.ToSingle(x[packet]);
            to.Y[packet] = R.ToSingle(y[packet]);
            to.Z[packet] = R.ToSingle(z[packet]);
        }
    }

    /// <summary>Rays collected by number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RayLanes<R> Collect(in LaneRun<I> run) => new(
        run.Collect<R, F>(OriginX), run.Collect<R, F>(OriginY), run.Collect<R, F>(OriginZ),
        run.Collect<R, F>(DirectionX), run.Collect<R, F>(DirectionY), run.Collect<R, F>(DirectionZ));

    /// <summary>One ray in doubles.</summary>
    public Ray this[int ray] => new(
        new Point3D(R.Take(OriginX, ray), R.Take(OriginY, ray), R.Take(OriginZ, ray)),
        new Vector3D(R.Take(DirectionX, ray), R.Take(DirectionY, ray), R.Take(DirectionZ, ray)));

    /// <summary>Writes one ray, rounded.</summary>
    public void Set(int ray, in Ray value) =>
        Set(ray, value.Origin.X, value.Origin.Y, value.Origin.Z, value.Direction.X, value.Direction.Y, value.Direction.Z);

    /// <summary>Writes one ray, rounded: coordinates of its origin, then of its direction.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Set(int ray, double x, double y, double z, double directionX, double directionY, double directionZ)
    {
        R.Put(OriginX, ray, x);
        R.Put(OriginY, ray, y);
        R.Put(OriginZ, ray, z);
        R.Put(DirectionX, ray, directionX);
        R.Put(DirectionY, ray, directionY);
        R.Put(DirectionZ, ray, directionZ);
    }

    /// <summary>Turns the spare lanes behind the last ray off.</summary>
    public void PadTail()
    {
        for (int ray = Count; ray < Packets * R.Width; ray++)
        {
            R.Put(OriginX, ray, 0);
            R.Put(OriginY, ray, 0);
            R.Put(OriginZ, ray, 0);
            R.Put(DirectionX, ray, 0);
            R.Put(DirectionY, ray, 0);
            R.Put(DirectionZ, ray, 1);
            R.Put(Limit, ray, -1);
        }
    }

    private enum Narrowed : byte
    {
        Nothing,
        Directions,
        All,
    }
}
