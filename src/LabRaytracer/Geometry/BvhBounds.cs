namespace LabRaytracer;

/// <summary>Finite boxes as the items of a tree.</summary>
internal readonly unsafe struct BvhBounds(Bounds[] boxes) : IBvhItems
{
    public int Count => boxes.Length;

    public Bounds All
    {
        get
        {
            Bounds all = Bounds.Empty;
            foreach (Bounds box in boxes)
            {
                all = Bounds.Union(all, box);
            }

            return all;
        }
    }

    public void Prepare(Point3D center)
    {
    }

    public void Release()
    {
    }

    public void Describe(Point3D center, BvhReference* references, int first, int end)
    {
        for (int item = first; item < end; item++)
        {
            references[item].Set(Float8.Max(BvhReach.Of(boxes[item].Min, center), BvhReach.Of(boxes[item].Max, center)), item);
        }
    }
}
