namespace LabRaytracer.Tests;

/// <summary>Objects in their groups, with the tree over them and a loop to compare with.</summary>
internal sealed class BvhSceneRun<R, F, I> : IDisposable
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly LaneMemory _memory = new();
    private readonly ShapeGroup<R, F, I>[] _groups;
    private readonly int[] _members;

    public BvhSceneRun((Shape Shape, Transform Transform)[] objects)
    {
        Dictionary<(Type, bool), ShapeGroup<R, F, I>> groups = [];
        _groups = new ShapeGroup<R, F, I>[objects.Length];
        _members = new int[objects.Length];
        for (int i = 0; i < objects.Length; i++)
        {
            (Shape shape, Transform transform) = objects[i];
            (Type, bool) key = (shape.GetType(), transform.IsIdentity);
            if (!groups.TryGetValue(key, out ShapeGroup<R, F, I>? group))
            {
                group = shape.CreateGroup<R, F, I>(transform);
                groups.Add(key, group);
            }

            _groups[i] = group;
            _members[i] = group.Add(shape, transform, i);
        }

        foreach (ShapeGroup<R, F, I> group in groups.Values)
        {
            group.Freeze(_memory, 1);
        }

        Tree = new SceneBvh<R, F, I>([.. objects.Select(o => o.Shape.Bounds.Transformed(o.Transform))], _groups, _members, 2);
    }

    public SceneBvh<R, F, I> Tree { get; }

    public void NearestByLoop(RayBatch<R, F, I> rays, HitBatch<R, F, I> hits)
    {
        for (int i = _groups.Length - 1; i >= 0; i--)
        {
            _groups[i].Nearest(_members[i], rays, hits, 0, rays.Packets);
        }
    }

    public void BlockByLoop(RayBatch<R, F, I> rays)
    {
        for (int i = _groups.Length - 1; i >= 0; i--)
        {
            _groups[i].Block(_members[i], rays, 0, rays.Packets);
        }
    }

    public void Dispose()
    {
        Tree.Dispose();
        _memory.Dispose();
    }
}
