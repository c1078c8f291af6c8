namespace LabRaytracer;

/// <summary>Makes the tables of the sky that samples of light from all around are drawn from.</summary>
internal static unsafe class EnvironmentTabulation<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const int Chunk = 1024;
    private const float MostLuminance = 1e30f;

    /// <summary>Makes the table of every such light of a scene; does nothing without one.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="threads">Threads, at least 1.</param>
    public static void Run(CompiledScene<R, F, I> scene, int threads)
    {
        foreach (CompiledEnvironment? environment in scene.Environments)
        {
            if (environment is not null)
            {
                EnvironmentLattice lattice = EnvironmentLattice.Of(environment.Light.Radiance);
                environment.Table = new EnvironmentTable(Luminance(scene, environment.Sky, lattice, threads), lattice.Even);
            }
        }
    }

    /// <summary>Mean luminance of the cells; each row is summed by one thread in a fixed order.</summary>
    private static double[,] Luminance(CompiledScene<R, F, I> scene, CompiledMaterial sky, EnvironmentLattice lattice, int threads)
    {
        double[,] luminance = new double[lattice.Rows, lattice.Columns];
        int next = -1;
        Parallel.For(0, threads, new ParallelOptions { MaxDegreeOfParallelism = threads }, _ =>
        {
            using LaneMemory memory = new();
            ShadingBuffers<R, F, I> buffers = new(scene, memory, Chunk, hasFootprints: false);
            WorkerCounters counters = new();
            for (int row = Interlocked.Increment(ref next); row < lattice.Rows; row = Interlocked.Increment(ref next))
            {
                for (int line = 0; line < lattice.Lines; line++)
                {
                    AddLine(sky, lattice, row, line, buffers, counters, luminance);
                }
            }
        });
        return luminance;
    }

    /// <summary>Adds the points of one line across a row of cells.</summary>
    private static void AddLine(
        CompiledMaterial sky, EnvironmentLattice lattice, int row, int line, ShadingBuffers<R, F, I> buffers, WorkerCounters counters, double[,] luminance)
    {
        int points = lattice.Columns * lattice.Points;
        double part = 1.0 / (lattice.Points * lattice.Lines);
        double cosine = Elementary.SinCosTurns(new Double1(0.5 * (row + ((line + 0.5) / lattice.Lines)) / lattice.Rows)).Cos.Value;
        for (int first = 0; first < points; first += Chunk)
        {
            int count = Math.Min(Chunk, points - first);
            Aim(first, points, cosine, buffers.Surfaces.Positions, (count + R.Width - 1) / R.Width);
            TextureStage.Run(sky, buffers, count, counters);
            for (int packet = 0; packet * R.Width < count; packet++)
            {
                sky.Emission.Read(buffers.Texels, packet, out buffers.Radiance.R[packet], out buffers.Radiance.G[packet], out buffers.Radiance.B[packet]);
            }

            for (int i = 0; i < count; i++)
            {
                // NaN and negative light are drawn as black: where they are looked up after all, the pixel shows it.
                float seen = buffers.Radiance.Take(i).Luminance;
                luminance[row, (first + i) / lattice.Points] += seen > 0 ? Math.Min(seen, MostLuminance) * part : 0;
            }
        }
    }

    private static void Aim(int first, int points, double cosine, in PositionBatch<R> at, int packets)
    {
        for (int packet = 0; packet < packets; packet++)
        {
            R turns = (R.Iota(first + (packet * R.Width)) + R.Of(0.5)) / R.Of(points);
            (R x, R y, R z) = SkyDirection.At(turns, R.Of(cosine));
            at.X[packet] = at.NormalX[packet] = x;
            at.Y[packet] = at.NormalY[packet] = y;
            at.Z[packet] = at.NormalZ[packet] = z;
        }
    }
}
