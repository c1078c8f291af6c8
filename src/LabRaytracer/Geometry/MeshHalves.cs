namespace LabRaytracer;

/// <summary>Some groups of lanes against a mesh, in its object space.</summary>
internal static unsafe class MeshHalves
{
    /// <summary>Nearest hits of groups of lanes: as a pencil together, or else half by half; groups that are no pencil, or too wide a one, join a crowd.</summary>
    public static void Nearest<R, F, I>(MeshData mesh, MeshTree tree, PencilLanes<R, F, I>* lanes, int count, MeshCrowd* crowd, HitBatch<R, F, I> hits, int packet, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        PencilAnswer answer = MeshPencil.Nearest(mesh, tree, lanes, count, hits, packet, number);
        if (answer == PencilAnswer.Found)
        {
            return;
        }

        if (answer == PencilAnswer.TooWide || count == 1)
        {
            for (int k = 0; k < count; k++)
            {
                if (crowd->Add<R, F, I>(tree, lanes[k].Ray, hits.T[packet + k], packet + k))
                {
                    MeshCrowd.Nearest(crowd, mesh, tree, hits, number);
                }
            }

            return;
        }

        int half = count / 2;
        Nearest(mesh, tree, lanes, half, crowd, hits, packet, number);
        Nearest(mesh, tree, lanes + half, count - half, crowd, hits, packet + half, number);
    }

    /// <summary>Blocks rays of groups of lanes, in the same way.</summary>
    public static void Block<R, F, I>(MeshData mesh, MeshTree tree, PencilLanes<R, F, I>* lanes, int count, MeshCrowd* crowd, RayBatch<R, F, I> rays, int packet, int number)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        PencilAnswer answer = MeshPencil.Block(mesh, tree, lanes, count, rays, packet, number);
        if (answer == PencilAnswer.Found)
        {
            return;
        }

        if (answer == PencilAnswer.TooWide || count == 1)
        {
            for (int k = 0; k < count; k++)
            {
                if (crowd->Add<R, F, I>(tree, lanes[k].Ray, rays.Limit[packet + k], packet + k))
                {
                    MeshCrowd.Block(crowd, mesh, tree, rays, number);
                }
            }

            return;
        }

        int half = count / 2;
        Block(mesh, tree, lanes, half, crowd, rays, packet, number);
        Block(mesh, tree, lanes + half, count - half, crowd, rays, packet + half, number);
    }
}
