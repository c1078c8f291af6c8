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

    public override void Differentiate(
        RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, int* memberOfObject, SurfaceBatch<R, F, I> surfaces, SurfaceSteps<F> steps, StepNeeds needs)
    {
        for (int i = 0; i < count; i++)
        {
            int ray = order[i];
            (Shape shape, Transform transform, _) = _members[memberOfObject[((int*)hits.Object)[ray]]];
            Hit hit = new(R.Take(hits.T, ray), ((int*)hits.Part)[ray], R.Take(hits.A, ray), R.Take(hits.B, ray));
            SurfacePoint here = shape.SurfaceAt(transform.ObjectFromWorld(rays[ray]), hit);
            CustomSteps.Change x = CustomSteps.Along(shape, here, transform.ObjectFromWorld(steps.WorldDx.Take(i)));
            CustomSteps.Change y = CustomSteps.Along(shape, here, transform.ObjectFromWorld(steps.WorldDy.Take(i)));
            steps.LocalDx.Put(i, x.Local);
            steps.LocalDy.Put(i, y.Local);
            Vector3D shading = new(R.Take(surfaces.ShadingX, i), R.Take(surfaces.ShadingY, i), R.Take(surfaces.ShadingZ, i));
            steps.NormalDx.Put(i, NormalChange(transform, here.ShadingNormal, x.Normal, shading));
            steps.NormalDy.Put(i, NormalChange(transform, here.ShadingNormal, y.Normal, shading));
            MappingGradient own = here.Position.SurfaceGradient;
            steps.SurfaceGradient.Put(i, own != default ? own : new MappingGradient(
                CustomSteps.Gradient(x.Local, y.Local, x.Surface.U, y.Surface.U), CustomSteps.Gradient(x.Local, y.Local, x.Surface.V, y.Surface.V)));
        }
    }

    /// <summary>Change of the world-space normal: the object-space one through the inverse transpose, its part along the normal taken away.</summary>
    private static Vector3D NormalChange(Transform transform, Vector3D objectNormal, Vector3D objectChange, Vector3D shading)
    {
        Vector3D change = transform.WorldNormalFromObject(objectChange);
        double length = Vector3D.Dot(transform.WorldNormalFromObject(objectNormal), shading);
        return length == 0 ? Vector3D.Zero : (change - (shading * Vector3D.Dot(change, shading))) / length;
    }

    private static bool Wins(double t, int number, double knownT, int knownNumber) => t < knownT || (t == knownT && number < knownNumber && knownNumber != HitBatch<R, F, I>.Miss);
}
