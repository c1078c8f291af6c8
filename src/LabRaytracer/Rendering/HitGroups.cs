namespace LabRaytracer;

/// <summary>Hits of a batch sorted by what they have in common, so that every lane of a later loop does the same work.</summary>
internal sealed unsafe class HitGroups<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly CompiledScene<R, F, I> _scene;
    private readonly int _keys;
    private readonly int* _keyOfRay;
    private readonly int* _end;

    public HitGroups(CompiledScene<R, F, I> scene, LaneMemory memory, int capacity)
    {
        _scene = scene;
        _keys = scene.Keys.Count + 2;
        _keyOfRay = memory.Column<int>(capacity, 1);
        _end = memory.Column<int>(_keys, 1);
        Start = memory.Column<int>(_keys, 1);
        Count = memory.Column<int>(_keys, 1);
        Order = memory.Column<int>(capacity + (_keys * R.Width), 1);
    }

    /// <summary>Key of the rays that hit nothing.</summary>
    public int MissKey => _keys - 2;

    /// <summary>Ray numbers, group after group; each group starts at a whole group of lanes and is padded with its last ray.</summary>
    public int* Order { get; }

    /// <summary>Where each key's group starts in <see cref="Order"/>.</summary>
    public int* Start { get; }

    /// <summary>Number of rays of each key.</summary>
    public int* Count { get; }

    /// <summary>Sorts the hits of a batch by counting.</summary>
    public void Sort(RayBatch<R, F, I> rays, HitBatch<R, F, I> hits)
    {
        new Span<int>(Count, _keys).Clear();
        int* objects = (int*)hits.Object;
        for (int ray = 0; ray < rays.Count; ray++)
        {
            int number = objects[ray];
            int key = number != HitBatch<R, F, I>.Miss ? _scene.KeyOf(number) : R.Take(rays.Limit, ray) < 0 ? _keys - 1 : MissKey;
            _keyOfRay[ray] = key;
            Count[key]++;
        }

        int start = 0;
        for (int key = 0; key < _keys; key++)
        {
            Start[key] = _end[key] = start;
            start += (Count[key] + R.Width - 1) / R.Width * R.Width;
        }

        for (int ray = 0; ray < rays.Count; ray++)
        {
            Order[_end[_keyOfRay[ray]]++] = ray;
        }

        PadTails();
    }

    private void PadTails()
    {
        for (int key = 0; key < _keys; key++)
        {
            int end = _end[key];
            if (Count[key] > 0)
            {
                for (int pad = end; pad % R.Width != 0; pad++)
                {
                    Order[pad] = Order[end - 1];
                }
            }
        }
    }
}
