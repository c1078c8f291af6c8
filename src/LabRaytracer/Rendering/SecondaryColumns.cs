using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Columns of reflected or refracted rays: of one group of hits, or all that wait for their turn.</summary>
internal sealed unsafe class SecondaryColumns<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Origins and directions of length 1, world space.</summary>
    public readonly VectorColumns<R> Origin, Direction;

    /// <summary>Pixel of each ray in the tile.</summary>
    public readonly I* Pixel;

    /// <summary>Number of the object whose outer side each ray leaves, or -1.</summary>
    public readonly I* Source;

    public SecondaryColumns(LaneMemory memory, int capacity, bool hasDifferentials)
    {
        Origin = new VectorColumns<R>(memory, capacity);
        Direction = new VectorColumns<R>(memory, capacity);
        Weight = new ColorColumns<F>(memory, capacity);
        Pixel = memory.Column<I>(capacity, I.Width);
        Source = memory.Column<I>(capacity, I.Width);
        Differentials = hasDifferentials ? new DifferentialColumns<F>(memory, capacity) : default;
        HasDifferentials = hasDifferentials;
    }

    /// <summary>Share of each ray's light that reaches its origin or, once it waits, its pixel.</summary>
    public ColorColumns<F> Weight { get; }

    /// <summary>Whether the rays carry differentials.</summary>
    public bool HasDifferentials { get; }

    /// <summary>How the rays change from sample to sample; only there if they carry differentials.</summary>
    public DifferentialColumns<F> Differentials { get; }

    /// <summary>Writes the shares of light that the rays bring.</summary>
    public void SetShare(int packet, F red, F green, F blue)
    {
        Weight.R[packet] = red;
        Weight.G[packet] = green;
        Weight.B[packet] = blue;
    }

    /// <summary>Writes rays: directions of any length become unit vectors; origins lie a slack beside the hit points.</summary>
    /// <param name="packet">Group of lanes.</param>
    /// <param name="s">The hits.</param>
    /// <param name="slack">How far along the geometric normal the origin lies; negative on the other side.</param>
    /// <param name="x">Direction.</param>
    /// <param name="y">Direction.</param>
    /// <param name="z">Direction.</param>
    public void SetRay(int packet, SurfaceBatch<R, F, I> s, R slack, R x, R y, R z)
    {
        R toUnit = R.Of(1) / R.Sqrt(Lane.Dot(x, y, z, x, y, z));
        Direction.Store(packet, x * toUnit, y * toUnit, z * toUnit);
        Origin.Store(
            packet,
            R.Fma(slack, s.NormalX[packet], s.PointX[packet]),
            R.Fma(slack, s.NormalY[packet], s.PointY[packet]),
            R.Fma(slack, s.NormalZ[packet], s.PointZ[packet]));
    }

    /// <summary>Writes some lanes of a group of other columns one behind the other. What lies behind them, up to a whole group, may change.</summary>
    /// <param name="from">The other columns.</param>
    /// <param name="packet">The group.</param>
    /// <param name="lanes">Bits of the lanes.</param>
    /// <param name="place">Number of the first ray that is written.</param>
    public void Pack(SecondaryColumns<R, F, I> from, int packet, uint lanes, int place)
    {
        Pack(from.Origin, packet, lanes, Origin, place);
        Pack(from.Direction, packet, lanes, Direction, place);
        Pack<F>(new(from.Weight.R, from.Weight.G, from.Weight.B), packet, lanes, new(Weight.R, Weight.G, Weight.B), place);
        Pack(from.Pixel, packet, lanes, (int*)Pixel + place);
        Pack(from.Source, packet, lanes, (int*)Source + place);
        if (HasDifferentials)
        {
            Pack(from.Differentials.OriginDx, packet, lanes, Differentials.OriginDx, place);
            Pack(from.Differentials.DirectionDx, packet, lanes, Differentials.DirectionDx, place);
            Pack(from.Differentials.OriginDy, packet, lanes, Differentials.OriginDy, place);
            Pack(from.Differentials.DirectionDy, packet, lanes, Differentials.DirectionDy, place);
        }
    }

    private static void Pack<T>(in VectorColumns<T> from, int packet, uint lanes, in VectorColumns<T> to, int place)
        where T : unmanaged, IReal<T>
    {
        if (AreFirst(lanes))
        {
            long at = (long)place * (sizeof(T) / T.Width);
            Unsafe.WriteUnaligned((byte*)to.X + at, from.X[packet]);
            Unsafe.WriteUnaligned((byte*)to.Y + at, from.Y[packet]);
            Unsafe.WriteUnaligned((byte*)to.Z + at, from.Z[packet]);
            return;
        }

        for (; lanes != 0; lanes &= lanes - 1)
        {
            to.Put(place++, from.Take((packet * T.Width) + BitOperations.TrailingZeroCount(lanes)));
        }
    }

    private static void Pack(I* from, int packet, uint lanes, int* to)
    {
        if (AreFirst(lanes))
        {
            I.Store(from[packet], to);
            return;
        }

        for (; lanes != 0; lanes &= lanes - 1)
        {
            *to++ = ((int*)from)[(packet * I.Width) + BitOperations.TrailingZeroCount(lanes)];
        }
    }

    /// <summary>Tells whether lanes are the first ones of their group, all of them perhaps.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static bool AreFirst(uint lanes) => (lanes & (lanes + 1)) == 0;
}
