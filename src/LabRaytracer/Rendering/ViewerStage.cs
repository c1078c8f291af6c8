namespace LabRaytracer;

/// <summary>Turns the normals of a group of hits to the viewer's side.</summary>
internal static unsafe class ViewerStage
{
    /// <summary>Collects the rays' directions; normals of hits from inside are reversed and the hits marked.</summary>
    /// <param name="rays">The rays that hit.</param>
    /// <param name="hits">Their hits.</param>
    /// <param name="order">Their numbers, padded to whole groups of lanes.</param>
    /// <param name="count">How many.</param>
    /// <param name="keepsDirections">Whether somebody reads the rays' directions.</param>
    /// <param name="buffers">Surface points; receives directions, the inside mask, and where shadow rays will come from.</param>
    public static void Run<R, F, I>(RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, bool keepsDirections, ShadingBuffers<R, F, I> buffers)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        int first = ((int*)hits.Object)[order[0]];
        bool isCommon = true;
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            run.Collect<R, F>(rays.DirectionX, rays.DirectionY, rays.DirectionZ, out R dx, out R dy, out R dz);
            if (keepsDirections)
            {
                buffers.DirectionX[packet] = dx;
                buffers.DirectionY[packet] = dy;
                buffers.DirectionZ[packet] = dz;
            }

            R nx = s.NormalX[packet], ny = s.NormalY[packet], nz = s.NormalZ[packet];
            R inside = R.Less(R.Zero, Lane.Dot(nx, ny, nz, dx, dy, dz));
            buffers.Inside[packet] = inside;
            I source = I.Select(R.MaskToInt32(inside), I.Of(-1), run.Collect(hits.Object));
            buffers.ShadowRays.Source[packet] = source;
            isCommon &= I.AllEqual(source, first);
            if (!s.SharesNormals)
            {
                // Shapes without normals of their own for shading have no parts.
                buffers.ShadowRays.SourcePart[packet] = run.Collect(hits.Part);
            }

            if (R.Any(inside))
            {
                s.NormalX[packet] = R.Select(inside, -nx, nx);
                s.NormalY[packet] = R.Select(inside, -ny, ny);
                s.NormalZ[packet] = R.Select(inside, -nz, nz);
            }

            if (!s.SharesNormals && R.Any(inside))
            {
                s.ShadingX[packet] = R.Select(inside, -s.ShadingX[packet], s.ShadingX[packet]);
                s.ShadingY[packet] = R.Select(inside, -s.ShadingY[packet], s.ShadingY[packet]);
                s.ShadingZ[packet] = R.Select(inside, -s.ShadingZ[packet], s.ShadingZ[packet]);
            }
        }

        buffers.ShadowRays.CommonSource = isCommon ? first : -1;
    }
}
