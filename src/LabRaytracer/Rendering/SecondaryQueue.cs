using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Reflected and refracted rays that wait for their turn, in columns. They lie where they arose, and are taken in the order of the rays that they come from.</summary>
[SkipLocalsInit]
internal sealed unsafe class SecondaryQueue<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly LaneMemory _memory;
    private int _capacity = 1024;
    private SecondaryColumns<R, F, I> _rays;
    private int* _order;
    private int _arisen;

    /// <param name="memory">Owns the columns.</param>
    /// <param name="hasDifferentials">Whether the rays carry differentials.</param>
    public SecondaryQueue(LaneMemory memory, bool hasDifferentials)
    {
        _memory = memory;
        _rays = new SecondaryColumns<R, F, I>(memory, _capacity, hasDifferentials);
        _order = memory.Column<int>(_capacity + I.Width, 1);
    }

    /// <summary>Number of rays in their order.</summary>
    public int Count { get; private set; }

    /// <summary>Takes rays in.</summary>
    /// <param name="rays">Columns of a group of hits.</param>
    /// <param name="packet">Group of lanes in them.</param>
    /// <param name="lanes">Bits of the lanes that are taken.</param>
    /// <returns>Place of the first; the others lie behind it.</returns>
    public int Arise(SecondaryColumns<R, F, I> rays, int packet, uint lanes)
    {
        int place = _arisen;
        _arisen += BitOperations.PopCount(lanes);
        if (place + R.Width > _capacity)
        {
            Grow();
        }

        _rays.Pack(rays, packet, lanes, place);
        return place;
    }

    /// <summary>The next rays in the order.</summary>
    /// <param name="places">Place of each ray, or below 0 for one that is not there.</param>
    /// <param name="count">How many.</param>
    public void Line(int* places, int count)
    {
        int* order = _order;
        int next = Count;
        for (int k = 0; k < count; k++)
        {
            order[next] = places[k];
            next += places[k] >= 0 ? 1 : 0;
        }

        Count = next;
    }

    /// <summary>Takes rays out.</summary>
    /// <param name="first">Number of the first ray in the order.</param>
    /// <param name="to">Receives as many rays as it counts.</param>
    /// <param name="weights">Receives the share of each ray's light that reaches its pixel.</param>
    /// <param name="pixels">Receives their pixels.</param>
    public void Take(int first, RayBatch<R, F, I> to, in ColorColumns<F> weights, I* pixels)
    {
        for (int packet = 0; packet < to.Packets; packet++)
        {
            LaneRun<I> run = new(_order + first + (packet * R.Width));
            Take(run, _rays.Origin, new(to.OriginX, to.OriginY, to.OriginZ), packet);
            Take(run, _rays.Direction, new(to.DirectionX, to.DirectionY, to.DirectionZ), packet);
            Take<F>(run, new(_rays.Weight.R, _rays.Weight.G, _rays.Weight.B), new(weights.R, weights.G, weights.B), packet);
            pixels[packet] = run.Collect(_rays.Pixel);
            to.Source[packet] = run.Collect(_rays.Source);
            to.Limit[packet] = R.Of(double.PositiveInfinity);
            if (to.HasDifferentials)
            {
                DifferentialColumns<F> changes = to.Differentials;
                Take(run, _rays.Differentials.OriginDx, changes.OriginDx, packet);
                Take(run, _rays.Differentials.DirectionDx, changes.DirectionDx, packet);
                Take(run, _rays.Differentials.OriginDy, changes.OriginDy, packet);
                Take(run, _rays.Differentials.DirectionDy, changes.DirectionDy, packet);
            }
        }
    }

    /// <summary>Forgets all rays, keeps the memory.</summary>
    public void Clear() => Count = _arisen = 0;

    private static void Take<T>(in LaneRun<I> run, in VectorColumns<T> from, in VectorColumns<T> to, int packet)
        where T : unmanaged, ILane<T, F, I>
    {
        run.Collect<T, F>(from.X, from.Y, from.Z, out T x, out T y, out T z);
        to.Store(packet, x, y, z);
    }

    /// <summary>Twice the room; the old columns are freed with all others.</summary>
    private void Grow()
    {
        SecondaryColumns<R, F, I> rays = new(_memory, 2 * _capacity, _rays.HasDifferentials);
        for (int packet = 0; packet < _capacity / R.Width; packet++)
        {
            rays.Pack(_rays, packet, uint.MaxValue >> (32 - R.Width), packet * R.Width);
        }

        int* order = _memory.Column<int>((2 * _capacity) + I.Width, 1);
        new ReadOnlySpan<int>(_order, Count).CopyTo(new Span<int>(order, Count));
        _rays = rays;
        _order = order;
        _capacity *= 2;
    }
}
