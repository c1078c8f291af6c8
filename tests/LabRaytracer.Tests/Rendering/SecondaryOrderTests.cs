namespace LabRaytracer.Tests.Rendering;

/// <summary>Secondary rays come in the order of the rays that they come from, however hits were grouped.</summary>
public sealed class SecondaryOrderTests
{
    [Fact]
    public void LineUp_RaysInAnyOrder_ReflectedBeforeRefractedRayByRay()
    {
        using Run<Double1, Float1, Int1> run = new(16, hasDifferentials: false);
        run.Reflect(9, 90);
        run.Refract(2, 21);
        run.Reflect(5, 50);
        run.Reflect(2, 20);
        run.Rays.LineUp(16);
        Assert.Equal([20, 21, 50, 90], run.Pixels());

        // The next batch goes behind, and the first one is not given twice.
        run.Reflect(0, 1);
        run.Rays.LineUp(16);
        Assert.Equal([20, 21, 50, 90, 1], run.Pixels());
        run.Queue.Clear();
        Assert.Equal(0, run.Queue.Count);
    }

    [Fact]
    public void LineUp_Layers_NearestFirst()
    {
        using Run<Double1, Float1, Int1> run = new(4, hasDifferentials: true);
        run.Refract(3, 31);
        run.Reflect(3, 30);
        run.Rays.EndLayer(4);
        run.Reflect(3, 32);
        run.Reflect(1, 10);
        run.Rays.EndLayer(4);
        run.Reflect(3, 33);
        run.Rays.LineUp(4);
        Assert.Equal([10, 30, 31, 32, 33], run.Pixels());
        Assert.Equal([10, 30, 31, 32, 33], run.Changes());
    }

    [Fact]
    public void Queue_MoreRaysThanItHadRoomFor_KeepsAll()
    {
        using Run<Double1, Float1, Int1> run = new(5000, hasDifferentials: true);
        for (int ray = 4999; ray >= 0; ray--)
        {
            run.Reflect(ray, ray);
        }

        run.Rays.LineUp(5000);
        Assert.Equal(Enumerable.Range(0, 5000), run.Pixels());
        Assert.Equal(1234, run.Changes()[1234]);
    }

    [Fact]
    public void Queue_SomeLanesOfGroups_KeepsThemInTheOrderOfTheirRays()
    {
        SomeLanes<Double4, Float4, Int4>();
        SomeLanes<Double8, Float8, Int8>();
        SomeLanes<Double16, Float16, Int16>();
        SomeLanes<Float16, Float16, Int16>();
    }

    /// <summary>Groups of lanes, the last ones first, of which all, the first, every other or no lanes are taken; enough of them that the queue grows.</summary>
    private static void SomeLanes<R, F, I>()
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        const int Count = 4096;
        uint all = uint.MaxValue >> (32 - R.Width);
        uint[] masks = [all, all >> 1, all & 0x5555, 0, all & 0xaaaa, 1];
        using Run<R, F, I> run = new(Count, hasDifferentials: true);
        List<int> expected = [];
        for (int first = Count - R.Width; first >= 0; first -= R.Width)
        {
            run.Take(first, masks[first / R.Width % masks.Length], isRefracted: false);
            run.Take(first, masks[first / R.Width % 5], isRefracted: true);
        }

        for (int ray = 0; ray < Count; ray++)
        {
            uint lane = 1u << (ray % R.Width);
            int group = ray / R.Width;
            expected.AddRange(Enumerable.Repeat(ray, ((masks[group % masks.Length] & lane) != 0 ? 1 : 0) + ((masks[group % 5] & lane) != 0 ? 1 : 0)));
        }

        run.Rays.LineUp(Count);
        Assert.Equal(expected, run.Pixels());
        Assert.Equal(expected.Select(ray => (double)ray), run.Changes());
    }

    /// <summary>A queue, and what lines its rays up.</summary>
    private sealed unsafe class Run<R, F, I> : IDisposable
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        private readonly LaneMemory _memory = new();
        private readonly SecondaryColumns<R, F, I> _columns;
        private readonly int* _order;
        private readonly bool _hasDifferentials;

        public Run(int capacity, bool hasDifferentials)
        {
            _hasDifferentials = hasDifferentials;
            _columns = new SecondaryColumns<R, F, I>(_memory, R.Width, hasDifferentials);
            _order = _memory.Column<int>(R.Width, 1);
            Queue = new SecondaryQueue<R, F, I>(_memory, hasDifferentials);
            Rays = new SecondaryRays<R, F, I>(_memory, capacity);
            Rays.Start(Queue);
        }

        public SecondaryQueue<R, F, I> Queue { get; }

        public SecondaryRays<R, F, I> Rays { get; }

        public void Dispose() => _memory.Dispose();

        /// <summary>Keeps one reflected ray, whose numbers are all the same.</summary>
        public void Reflect(int ray, int number) => Rays.Reflect(Order(ray), 1, Arise(number, 1));

        /// <summary>Keeps one refracted ray, whose numbers are all the same.</summary>
        public void Refract(int ray, int number) => Rays.Refract(Order(ray), 1, Arise(number, 1));

        /// <summary>Keeps some lanes of a group of rays, whose numbers are those of the rays.</summary>
        public void Take(int first, uint lanes, bool isRefracted)
        {
            int place = Arise(first, lanes);
            if (isRefracted)
            {
                Rays.Refract(Order(first), lanes, place);
            }
            else
            {
                Rays.Reflect(Order(first), lanes, place);
            }
        }

        /// <summary>Pixels of the rays in their order; all other numbers of a ray are the same.</summary>
        public int[] Pixels()
        {
            RayBatch<R, F, I> rays = new(_memory, Queue.Count, _hasDifferentials) { Count = Queue.Count };
            ColorColumns<F> weights = new(_memory, Queue.Count);
            I* pixels = _memory.Column<I>(Queue.Count, I.Width);
            Queue.Take(0, rays, weights, pixels);
            int[] result = new ReadOnlySpan<int>(pixels, Queue.Count).ToArray();
            for (int ray = 0; ray < result.Length; ray++)
            {
                double number = result[ray];
                Assert.Equal((number, number, number), (rays[ray].Origin.X, rays[ray].Direction.Z, weights.Take(ray).G));
                Assert.Equal(result[ray], ((int*)rays.Source)[ray]);
            }

            return result;
        }

        /// <summary>Changes of the rays' origins in their order.</summary>
        public double[] Changes()
        {
            RayBatch<R, F, I> rays = new(_memory, Queue.Count, hasDifferentials: true) { Count = Queue.Count };
            Queue.Take(0, rays, new ColorColumns<F>(_memory, Queue.Count), _memory.Column<I>(Queue.Count, I.Width));
            return [.. Enumerable.Range(0, Queue.Count).Select(ray => rays.Differentials.Take(ray).OriginDx.X)];
        }

        private int* Order(int first)
        {
            for (int lane = 0; lane < R.Width; lane++)
            {
                _order[lane] = first + lane;
            }

            return _order;
        }

        private int Arise(int first, uint lanes)
        {
            for (int lane = 0; lane < R.Width; lane++)
            {
                int number = first + lane;
                Vector3D vector = new(number, number, number);
                _columns.Origin.Put(lane, vector);
                _columns.Direction.Put(lane, vector);
                _columns.Weight.Put(lane, new Intensity(number, number, number));
                ((int*)_columns.Pixel)[lane] = ((int*)_columns.Source)[lane] = number;
                if (_hasDifferentials)
                {
                    _columns.Differentials.Put(lane, new RayDifferential(vector, vector, vector, vector), 1);
                }
            }

            return Queue.Arise(_columns, 0, lanes);
        }
    }
}
