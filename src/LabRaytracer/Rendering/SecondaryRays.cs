using System.Numerics;

namespace LabRaytracer;

/// <summary>The reflected and refracted rays that a batch leaves behind, lined up in the order of the rays they come from.</summary>
/// <remarks>
/// The order does not depend on how hits were grouped or batches were cut: so neither does the order in which light is added to a pixel, to the last bit.
/// </remarks>
internal sealed unsafe class SecondaryRays<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const int Absent = -1;

    private readonly int* _reflected, _refracted, _both;
    private readonly List<(int Ray, int Turn, int Place)> _layers = [];
    private SecondaryQueue<R, F, I>? _queue;
    private bool _anyReflected, _anyRefracted;

    /// <param name="memory">Owns the columns.</param>
    /// <param name="capacity">Most rays of a batch.</param>
    public SecondaryRays(LaneMemory memory, int capacity)
    {
        _reflected = memory.Column<int>(capacity, 1);
        _refracted = memory.Column<int>(capacity, 1);
        _both = memory.Column<int>(2 * capacity, 1);
        Forget(capacity);
    }

    /// <summary>Where the rays are kept, once a batch has been started.</summary>
    public SecondaryQueue<R, F, I> Queue => _queue!;

    /// <summary>Starts a batch.</summary>
    /// <param name="queue">Receives the rays.</param>
    public void Start(SecondaryQueue<R, F, I> queue) => _queue = queue;

    /// <summary>Tells where reflected rays are kept.</summary>
    /// <param name="order">Numbers of the rays of a group of lanes, in increasing order.</param>
    /// <param name="lanes">Bits of the lanes that are reflected.</param>
    /// <param name="place">Place of the first one's reflected ray; the others lie behind it.</param>
    public void Reflect(int* order, uint lanes, int place)
    {
        _anyReflected = true;
        Keep(_reflected, order, lanes, place);
    }

    /// <summary>Tells where refracted rays are kept.</summary>
    /// <param name="order">Numbers of the rays of a group of lanes, in increasing order.</param>
    /// <param name="lanes">Bits of the lanes that are refracted.</param>
    /// <param name="place">Place of the first one's refracted ray; the others lie behind it.</param>
    public void Refract(int* order, uint lanes, int place)
    {
        _anyRefracted = true;
        Keep(_refracted, order, lanes, place);
    }

    /// <summary>Sets the rays of one layer of surfaces aside: the next layer has rays of its own.</summary>
    /// <param name="count">Number of rays of the batch.</param>
    public void EndLayer(int count)
    {
        if (!_anyReflected && !_anyRefracted)
        {
            return;
        }

        for (int ray = 0; ray < count; ray++)
        {
            if (_reflected[ray] != Absent)
            {
                _layers.Add((ray, _layers.Count, _reflected[ray]));
            }

            if (_refracted[ray] != Absent)
            {
                _layers.Add((ray, _layers.Count, _refracted[ray]));
            }
        }

        Forget(count);
    }

    /// <summary>Lines up what was kept.</summary>
    /// <param name="count">Number of rays of the batch.</param>
    public void LineUp(int count)
    {
        if (_layers.Count > 0)
        {
            // What lies behind the layers is the last one.
            EndLayer(count);
            _layers.Sort(static (a, b) => (a.Ray, a.Turn).CompareTo((b.Ray, b.Turn)));
            foreach ((_, _, int place) in _layers)
            {
                int one = place;
                Queue.Line(&one, 1);
            }

            _layers.Clear();
        }
        else if (_anyRefracted)
        {
            for (int ray = 0; ray < count; ray++)
            {
                _both[2 * ray] = _reflected[ray];
                _both[(2 * ray) + 1] = _refracted[ray];
            }

            Queue.Line(_both, 2 * count);
            Forget(count);
        }
        else if (_anyReflected)
        {
            Queue.Line(_reflected, count);
            Forget(count);
        }
    }

    private static void Keep(int* places, int* order, uint lanes, int place)
    {
        if (lanes == uint.MaxValue >> (32 - R.Width) && order[I.Width - 1] - order[0] == I.Width - 1)
        {
            I.Store(I.Iota(place), places + order[0]);
            return;
        }

        for (; lanes != 0; lanes &= lanes - 1)
        {
            places[order[BitOperations.TrailingZeroCount(lanes)]] = place++;
        }
    }

    private void Forget(int count)
    {
        new Span<int>(_reflected, count).Fill(Absent);
        new Span<int>(_refracted, count).Fill(Absent);
        _anyReflected = _anyRefracted = false;
    }
}
