namespace LabRaytracer;

/// <summary>Tests the triangles of leaves.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
/// <typeparam name="P">How positions are stored.</typeparam>
/// <typeparam name="TSink">What happens to hits.</typeparam>
internal unsafe struct MeshLeaf<R, F, I, P, TSink>(MeshTriangle* triangles, P positions, in RayLanes<R> ray, in R active, in TSink sink) : IBvhLeaf<R>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
    where P : struct, IMeshPositions
    where TSink : struct, IMeshSink<R>
{
    /// <summary>What was found.</summary>
    public TSink Sink = sink;

    private readonly RayLanes<R> _source = ray;
    private readonly R _active = active;
    private WatertightRay<R> _ray;
    private bool _isPrepared;

    public bool Visit(int first, int count, ref R limit)
    {
        // Many rays meet no leaf at all.
        if (!_isPrepared)
        {
            _ray = new WatertightRay<R>(_source, _active);
            _isPrepared = true;
        }

        bool isLowered = false;
        for (MeshTriangle* triangle = triangles + first; triangle < triangles + first + count; triangle++)
        {
            R mask = _ray.SharedAxis >= 0
                ? IntersectShared(triangle, out R t, out R weight1, out R weight2)
                : IntersectMixed(triangle, out t, out weight1, out weight2);
            mask &= R.LessOrEqual(t, limit);
            if (R.Any(mask))
            {
                isLowered |= Sink.Take(mask, t, weight1, weight2, triangle->Number, ref limit);
            }
        }

        return isLowered;
    }

    /// <summary>All rays have the same largest axis: turned axes are read from memory.</summary>
    private readonly R IntersectShared(MeshTriangle* triangle, out R t, out R weight1, out R weight2)
    {
        int z = _ray.SharedAxis;
        int x = z == 2 ? 0 : z + 1;
        int y = x == 2 ? 0 : x + 1;
        int v0 = triangle->Element0, v1 = triangle->Element1, v2 = triangle->Element2;
        return WatertightTriangle.IntersectTurned(
            _ray,
            At(v0 + x), At(v0 + y), At(v0 + z), At(v1 + x), At(v1 + y), At(v1 + z), At(v2 + x), At(v2 + y), At(v2 + z),
            out t, out weight1, out weight2);
    }

    private readonly R IntersectMixed(MeshTriangle* triangle, out R t, out R weight1, out R weight2)
    {
        int v0 = triangle->Element0, v1 = triangle->Element1, v2 = triangle->Element2;
        return WatertightTriangle.Intersect(
            _ray,
            At(v0), At(v0 + 1), At(v0 + 2), At(v1), At(v1 + 1), At(v1 + 2), At(v2), At(v2 + 1), At(v2 + 2),
            out t, out weight1, out weight2);
    }

    private readonly R At(int element) => positions.At<R, F, I>(element);
}
