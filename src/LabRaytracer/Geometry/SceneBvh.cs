using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>All objects of a scene: a tree over the bounded ones where there are many, one after the other where there are few.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
/// <remarks>Immutable, thread safe. Groups must be frozen before the first ray.</remarks>
[SkipLocalsInit]
internal sealed class SceneBvh<R, F, I> : IDisposable
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Up to this many bounded objects, a loop over them is faster than a tree.</summary>
    private const int FewObjects = 8;

    /// <summary>Fewer bounded objects are looked at by every ray, unless bounds of the rays are known: finding them costs as much.</summary>
    private const int LeastBundled = 3;

    /// <summary>Most objects that are listed as possible blockers.</summary>
    public const int MostBlockers = BundleSearch.Most + 4;

    /// <summary>Larger coordinates would overflow in the floats of the tree.</summary>
    private const double LargestCoordinate = 1e18;

    private readonly BvhSceneEntry<R, F, I>[] _outside;
    private readonly BvhSceneEntry<R, F, I>[] _inside;
    private readonly BundleSearch _search;
    private readonly Bvh? _tree;
    private readonly bool _usesBundles;

    /// <summary>Sorts the objects.</summary>
    /// <param name="bounds">World box of each object; may be unbounded.</param>
    /// <param name="groupOfEntry">Group of each object.</param>
    /// <param name="memberOfEntry">Number of each object in its group.</param>
    /// <param name="threads">Threads that may work on it, at least 1.</param>
    /// <param name="usesBundles">Whether objects that no ray of a bundle can meet are left out for all of them at once.</param>
    public SceneBvh(ReadOnlySpan<Bounds> bounds, ShapeGroup<R, F, I>[] groupOfEntry, int[] memberOfEntry, int threads, bool usesBundles = true)
    {
        _usesBundles = usesBundles;
        List<Bounds> boxes = [];
        List<BvhSceneEntry<R, F, I>> boxed = [], outside = [];
        for (int entry = 0; entry < bounds.Length; entry++)
        {
            BvhSceneEntry<R, F, I> added = new(groupOfEntry[entry], memberOfEntry[entry]);
            if (bounds[entry].IsEmpty)
            {
                continue;
            }

            if (FitsTree(bounds[entry]))
            {
                boxes.Add(bounds[entry]);
                boxed.Add(added);
            }
            else
            {
                outside.Add(added);
            }
        }

        int[] order = [.. Enumerable.Range(0, boxed.Count)];
        if (boxed.Count > FewObjects)
        {
            _tree = Bvh.Build(new BvhBounds([.. boxes]), new BvhCost(ItemCost: 4, MaximumLeaf: 2), threads, out order);
        }

        _inside = [.. order.Select(item => boxed[item])];
        _outside = [.. outside];
        _search = new BundleSearch(_tree, [.. order.Select(item => boxes[item])]);
    }

    /// <summary>Bytes of the tree.</summary>
    public long Bytes => _tree?.Bytes ?? 0;

    /// <summary>Keeps the nearest hits of all objects in groups of lanes [firstPacket, endPacket).</summary>
    public void Nearest(RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int firstPacket, int endPacket) => Run(rays, hits, firstPacket, endPacket);

    /// <summary>Turns off (limit below 0) the rays in groups of lanes [firstPacket, endPacket) that any object blocks before their limit.</summary>
    public void Block(RayBatch<R, F, I> rays, int firstPacket, int endPacket) => Run(rays, null, firstPacket, endPacket);

    /// <summary>Lists the objects that may block any of some shadow rays.</summary>
    /// <param name="bounds">Bounds of the rays.</param>
    /// <param name="source">Number of the object whose outer side all of them leave, or -1.</param>
    /// <param name="found">Receives the objects; room for <see cref="MostBlockers"/>.</param>
    /// <returns>How many; -1 where they are too many.</returns>
    public unsafe int FindBlockers(in RayBounds bounds, int source, BundleCandidate* found)
    {
        int count = 0, listed = _search.Find(RayBundle.Of(bounds, _search.Size), found);
        for (int k = 0; k < listed; k++)
        {
            found[count] = found[k];
            count += MayBlock(_inside[found[k].Place], bounds, source) ? 1 : 0;
        }

        for (int place = 0; place < _outside.Length && listed >= 0; place++)
        {
            if (MayBlock(_outside[place], bounds, source))
            {
                if (count == MostBlockers)
                {
                    return -1;
                }

                found[count++] = new BundleCandidate(~place, 0);
            }
        }

        return listed < 0 ? -1 : count;
    }

    /// <summary>Turns off the rays in groups of lanes [first, end) that any of the objects from <see cref="FindBlockers"/> blocks before their limit; any object at all where those were too many.</summary>
    public unsafe void Block(RayBatch<R, F, I> rays, int first, int end, BundleCandidate* found, int count)
    {
        if (count < 0)
        {
            Block(rays, first, end);
        }

        for (int k = 0; k < count; k++)
        {
            int place = found[k].Place;
            Visit(place < 0 ? _outside[~place] : _inside[place], rays, null, rays.Limit, found[k].Start, first, end);
        }
    }

    public void Dispose() => _tree?.Dispose();

    private static bool MayBlock(in BvhSceneEntry<R, F, I> entry, in RayBounds bounds, int source) => entry.Group.MayBlock(entry.Member, bounds, source);

    private static bool FitsTree(Bounds bounds) =>
        bounds.IsFinite && Fits(bounds.Min) && Fits(bounds.Max);

    private static bool Fits(Point3D corner) =>
        Math.Abs(corner.X) <= LargestCoordinate && Math.Abs(corner.Y) <= LargestCoordinate && Math.Abs(corner.Z) <= LargestCoordinate;

    private void Run(RayBatch<R, F, I> rays, HitBatch<R, F, I>? hits, int firstPacket, int endPacket)
    {
        foreach (BvhSceneEntry<R, F, I> entry in _outside)
        {
            entry.Visit(rays, hits, firstPacket, endPacket);
        }

        if (_inside.Length < LeastBundled && (!_usesBundles || rays.Bounds is null))
        {
            foreach (BvhSceneEntry<R, F, I> entry in _inside)
            {
                entry.Visit(rays, hits, firstPacket, endPacket);
            }

            return;
        }

        for (int first = firstPacket; first < endPacket && _inside.Length > 0; first += RayBatch<R, F, I>.BundlePackets)
        {
            RunBundle(rays, hits, first, Math.Min(first + RayBatch<R, F, I>.BundlePackets, endPacket));
        }
    }

    /// <summary>Looks at the objects that a bundle may meet, the nearest one first; one group of lanes after the other where there are too many.</summary>
    private unsafe void RunBundle(RayBatch<R, F, I> rays, HitBatch<R, F, I>? hits, int firstPacket, int endPacket)
    {
        R* limits = hits == null ? rays.Limit : hits.T;
        RayBundle bundle;
        if (rays.Bounds is { } bounds && _usesBundles && firstPacket % RayBatch<R, F, I>.BundlePackets == 0)
        {
            bundle = RayBundle.Of(bounds[firstPacket / RayBatch<R, F, I>.BundlePackets], _search.Size);
        }
        else
        {
            rays.Narrow(firstPacket, endPacket);
            bundle = RayBundle.Of(rays, limits, firstPacket, endPacket, _search.Size);
        }

        if (bundle.IsUsable && bundle.IsOff)
        {
            return;
        }

        BundleCandidate* candidates = stackalloc BundleCandidate[BundleSearch.Most];
        int count = _usesBundles ? _search.Find(bundle, candidates) : -1;
        for (int packet = firstPacket; packet < endPacket && count < 0; packet++)
        {
            RunPacket(rays, hits, packet);
        }

        for (int k = 0; k < count; k++)
        {
            Visit(_inside[candidates[k].Place], rays, hits, limits, candidates[k].Start, firstPacket, endPacket);
        }
    }

    /// <summary>Looks at an object for the groups of lanes of a bundle that reach to where it may be met; neighbours at once.</summary>
    private static unsafe void Visit(
        in BvhSceneEntry<R, F, I> entry, RayBatch<R, F, I> rays, HitBatch<R, F, I>? hits, R* limits, double start, int firstPacket, int endPacket)
    {
        R nearest = R.Of(start);
        int first = firstPacket;
        for (int packet = firstPacket; packet < endPacket; packet++)
        {
            if (!R.Any(R.LessOrEqual(nearest, limits[packet])))
            {
                if (first < packet)
                {
                    entry.Visit(rays, hits, first, packet);
                }

                first = packet + 1;
            }
        }

        if (first < endPacket)
        {
            entry.Visit(rays, hits, first, endPacket);
        }
    }

    private unsafe void RunPacket(RayBatch<R, F, I> rays, HitBatch<R, F, I>? hits, int packet)
    {
        if (_tree != null)
        {
            BvhSceneLeaf<R, F, I> leaf = new(_inside, rays, hits, packet);
            BvhTraversal.Run<R, F, I, BvhSceneLeaf<R, F, I>>(_tree, rays.Load(packet), hits == null ? rays.Limit[packet] : hits.T[packet], ref leaf);
            return;
        }

        foreach (BvhSceneEntry<R, F, I> entry in _inside)
        {
            entry.Visit(rays, hits, packet, packet + 1);
        }
    }
}
