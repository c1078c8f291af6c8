namespace LabRaytracer;

/// <summary>Shapes that only know one ray at a time: a plain loop over the batch.</summary>
internal sealed unsafe class CustomGroup<R, F, I> : ShapeGroup<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly List<(Shape Shape, Transform Transform, int Number)> _members = [];

    public override int Add(Shape shape, Transform transform, int number)
    {
        _members.Add((shape, transform, number));
        return _members.Count - 1;
    }

    public override void Freeze(LaneMemory memory, int threads)
    {
    }

    public override void Nearest(int member, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int first, int end)
    {
        (Shape shape, Transform transform, int number) = _members[member];
        for (int ray = first * R.Width; ray < Math.Min(end * R.Width, rays.Count); ray++)
        {
            // The next double above the limit lets a tie through, which the smaller number then wins.
            double limit = Math.BitIncrement(R.Take(hits.T, ray));
            Ray localRay = transform.ObjectFromWorld(rays[ray]);
            if (limit > 0 && shape.Intersect(localRay, limit, out Hit hit) && Wins(hit.T, number, R.Take(hits.T, ray), ((int*)hits.Object)[ray]))
            {
                R.Put(hits.T, ray, hit.T);
                R.Put(hits.A, ray, hit.A);
                R.Put(hits.B, ray, hit.B);
                ((int*)hits.Object)[ray] = number;
                ((int*)hits.Part)[ray] = hit.Part;
            }
        }
    }

    public override void Block(int member, RayBatch<R, F, I> rays, int first, int end)
    {
        (Shape shape, Transform transform, _) = _members[member];
        for (int ray = first * R.Width; ray < Math.Min(end * R.Width, rays.Count); ray++)
        {
            double limit = R.Take(rays.Limit, ray);
            if (limit > 0 && shape.Intersect(transform.ObjectFromWorld(rays[ray]), limit, out Hit hit) && hit.T < limit)
            {
                R.Put(rays.Limit, ray, -1);
            }
        }
    }

    public override void Surface(
        RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, int* memberOfObject, SurfaceBatch<R, F, I> surfaces, SurfaceNeeds needs)
    {
        for (int i = 0; i < count; i++)
        {
            int ray = order[i];
            (Shape shape, Transform transform, _) = _members[memberOfObject[((int*)hits.Object)[ray]]];
            Hit hit = new(R.Take(hits.T, ray), ((int*)hits.Part)[ray], R.Take(hits.A, ray), R.Take(hits.B, ray));
            surfaces.Put(i, shape.SurfaceAt(transform.ObjectFromWorld(rays[ray]), hit), transform);
        }
    }

    private static bool Wins(double t, int number, double knownT, int knownNumber) => t < knownT || (t == knownT && number < knownNumber && knownNumber != HitBatch<R, F, I>.Miss);
}
