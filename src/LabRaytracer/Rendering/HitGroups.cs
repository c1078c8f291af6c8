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
    private readonly int* _keyOfPacket;
    private readonly int* _end;

    public HitGroups(CompiledScene<R, F, I> scene, LaneMemory memory, int capacity)
    {
        _scene = scene;
        _keys = scene.Keys.Count + 2;
        _keyOfRay = memory.Column<int>(capacity, 1);
        _keyOfPacket = memory.Column<int>(capacity / R.Width, 1);
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
        for (int packet = 0; packet < rays.Packets; packet++)
        {
            CountPacket(rays, hits, packet);
        }

        int start = 0;
        for (int key = 0; key < _keys; key++)
        {
            Start[key] = _end[key] = start;
            start += (Count[key] + R.Width - 1) / R.Width * R.Width;
        }

        for (int packet = 0; packet < rays.Packets; packet++)
        {
            PlacePacket(packet, rays.Count);
        }

        PadTails();
    }

    /// <summary>Finds the keys of one group of lanes: at once where all of them see the same object.</summary>
    private void CountPacket(RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int packet)
    {
        int* objects = (int*)(hits.Object + packet);
        int first = packet * R.Width, number = objects[0];
        bool isSame = rays.Count - first >= R.Width && I.AllEqual(hits.Object[packet], number);
        if (isSame && (number != HitBatch<R, F, I>.Miss || R.All(R.LessOrEqual(R.Zero, rays.Limit[packet]))))
        {
            int key = number != HitBatch<R, F, I>.Miss ? _scene.KeyOf(number) : MissKey;
            _keyOfPacket[packet] = key;
            Count[key] += R.Width;
            return;
        }

        _keyOfPacket[packet] = -1;
        for (int ray = first; ray < Math.Min(first + R.Width, rays.Count); ray++)
        {
            number = objects[ray - first];
            int key = number != HitBatch<R, F, I>.Miss ? _scene.KeyOf(number) : R.Take(rays.Limit, ray) < 0 ? _keys - 1 : MissKey;
            _keyOfRay[ray] = key;
            Count[key]++;
        }
    }

    private void PlacePacket(int packet, int count)
    {
        int first = packet * R.Width;
        if (_keyOfPacket[packet] is >= 0 and int key)
        {
            I.Store(I.Iota(first), Order + _end[key]);
            _end[key] += R.Width;
            return;
        }

        for (int ray = first; ray < Math.Min(first + R.Width, count); ray++)
        {
            Order[_end[_keyOfRay[ray]]++] = ray;
        }
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
