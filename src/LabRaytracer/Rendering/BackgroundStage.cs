namespace LabRaytracer;

/// <summary>What rays see that hit nothing.</summary>
internal static unsafe class BackgroundStage
{
    /// <summary>Radiance of the rays of a group, by their directions.</summary>
    public static void Run<R, F, I>(
        CompiledScene<R, F, I> scene, RayBatch<R, F, I> rays, int* order, int count, ShadingBuffers<R, F, I> buffers, WorkerCounters counters)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        int packets = (count + R.Width - 1) / R.Width;
        CompiledMaterial background = scene.Background;
        if (background.Lookups.Count > 0)
        {
            PositionBatch<R> at = buffers.Surfaces.Positions;
            bool isTurned = !scene.BackgroundRotation.IsIdentity;
            for (int packet = 0; packet < packets; packet++)
            {
                LaneRun<I> run = new(order, packet * R.Width, count);
                R x = run.Collect<R, F>(rays.DirectionX), y = run.Collect<R, F>(rays.DirectionY), z = run.Collect<R, F>(rays.DirectionZ);
                at.WorldX[packet] = at.WorldNormalX[packet] = x;
                at.WorldY[packet] = at.WorldNormalY[packet] = y;
                at.WorldZ[packet] = at.WorldNormalZ[packet] = z;
                (x, y, z) = isTurned ? DirectionTurn.Apply(scene.BackgroundRotation.ObjectFromWorldRows, x, y, z) : (x, y, z);
                at.X[packet] = at.NormalX[packet] = x;
                at.Y[packet] = at.NormalY[packet] = y;
                at.Z[packet] = at.NormalZ[packet] = z;
            }

            if (buffers.Footprints is not null)
            {
                FootprintStage.StepBackground(rays, order, count, scene.BackgroundRotation, buffers);
            }

            TextureStage.Run(background, buffers, count, counters);
        }

        for (int packet = 0; packet < packets; packet++)
        {
            background.Emission.Read(buffers.Texels, packet, out buffers.Radiance.R[packet], out buffers.Radiance.G[packet], out buffers.Radiance.B[packet]);
        }
    }
}
