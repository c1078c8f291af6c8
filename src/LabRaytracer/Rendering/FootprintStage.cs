using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>What samples cover of surfaces and of texture space, from the differentials of their rays.</summary>
/// <remarks>In float lanes: a footprint decides how much is filtered, not where.</remarks>
internal static unsafe class FootprintStage
{
    /// <summary>
    /// Cosine of the angle between ray and surface below which it counts as this one: rays that graze more have a footprint without end.
    /// </summary>
    public const double LeastCosine = 1e-6;

    /// <summary>Steps on the surfaces of a group of hits, and what changes over them.</summary>
    /// <param name="group">The shapes that were hit.</param>
    /// <param name="rays">The rays that hit, with differentials.</param>
    /// <param name="hits">Their hits.</param>
    /// <param name="order">Their numbers, padded to whole groups of lanes.</param>
    /// <param name="count">How many.</param>
    /// <param name="memberOfObject">The member number of each object number.</param>
    /// <param name="buffers">Surfaces and directions of the group; receives the steps.</param>
    /// <param name="needs">What somebody reads of them.</param>
    public static void Step<R, F, I>(
        ShapeGroup<R, F, I> group, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count, int* memberOfObject,
        ShadingBuffers<R, F, I> buffers, StepNeeds needs)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        SurfaceSteps<F> steps = buffers.Footprints!.Steps;
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        if (rays.Pinhole is { } pinhole)
        {
            PinholeFootprints.Step(pinhole, rays, hits.T, order, count, new VectorColumns<R>(s.NormalX, s.NormalY, s.NormalZ), steps.WorldDx, steps.WorldDy);
        }
        else
        {
            Step(rays, hits.T, order, count, s, steps);
        }

        group.Differentiate(rays, hits, order, count, memberOfObject, s, steps, needs);
    }

    /// <summary>Steps on the surfaces in world space, from the differentials of any rays.</summary>
    private static void Step<R, F, I>(RayBatch<R, F, I> rays, R* distances, int* order, int count, SurfaceBatch<R, F, I> s, SurfaceSteps<F> steps)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        DifferentialColumns<F> d = rays.Differentials;
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            run.Collect<R, F>(rays.DirectionX, rays.DirectionY, rays.DirectionZ, out R dx, out R dy, out R dz);
            R nx = s.NormalX[packet], ny = s.NormalY[packet], nz = s.NormalZ[packet];

            // Normals point to the viewer: the product is negative.
            F inverse = R.ToSingle(R.Of(1) / R.Min(Lane.Dot(nx, ny, nz, dx, dy, dz), R.Of(-LeastCosine)));
            F t = R.ToSingle(run.Collect<R, F>(distances)), x = R.ToSingle(dx), y = R.ToSingle(dy), z = R.ToSingle(dz);
            Transfer(packet, run, t, inverse, (x, y, z), (R.ToSingle(nx), R.ToSingle(ny), R.ToSingle(nz)), d.OriginDx, d.DirectionDx, steps.WorldDx);
            Transfer(packet, run, t, inverse, (x, y, z), (R.ToSingle(nx), R.ToSingle(ny), R.ToSingle(nz)), d.OriginDy, d.DirectionDy, steps.WorldDy);
        }
    }

    /// <summary>Steps on the background, whose local point is the ray's direction, turned back.</summary>
    public static void StepBackground<R, F, I>(
        RayBatch<R, F, I> rays, int* order, int count, Transform rotation, ShadingBuffers<R, F, I> buffers)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        SurfaceSteps<F> steps = buffers.Footprints!.Steps;
        DifferentialColumns<F> d = rays.Differentials;
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            TurnBack(packet, run, Transform.Identity, d.DirectionDx, steps.WorldDx);
            TurnBack(packet, run, Transform.Identity, d.DirectionDy, steps.WorldDy);
            TurnBack(packet, run, rotation, d.DirectionDx, steps.LocalDx);
            TurnBack(packet, run, rotation, d.DirectionDy, steps.LocalDy);
        }
    }

    private static void TurnBack<F, I>(int packet, in LaneRun<I> run, Transform rotation, in VectorColumns<F> direction, in VectorColumns<F> result)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F x = run.Collect<F, F>(direction.X), y = run.Collect<F, F>(direction.Y), z = run.Collect<F, F>(direction.Z);
        (x, y, z) = rotation.IsIdentity ? (x, y, z) : DirectionTurn.Apply(rotation.ObjectFromWorldRows, x, y, z);
        result.Store(packet, x, y, z);
    }

    /// <summary>Footprints of the coordinate sets that some filter reads.</summary>
    /// <param name="material">Textures and mappings.</param>
    /// <param name="buffers">Positions and steps of the group; receives the footprints.</param>
    /// <param name="count">How many hits.</param>
    public static void Map<R, F, I>(LookupList material, ShadingBuffers<R, F, I> buffers, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        for (int set = 0; set < material.Coordinates.Count; set++)
        {
            if (material.NeedsFootprint(set))
            {
                Map(material.Coordinates[set], buffers.Surfaces, buffers.Footprints!, set, count);
            }
        }
    }

    /// <summary>Changes of one coordinate set over the steps on the surfaces.</summary>
    /// <param name="set">The mapping.</param>
    /// <param name="surfaces">Positions.</param>
    /// <param name="footprints">The steps; receives the changes.</param>
    /// <param name="number">Number of the coordinate set.</param>
    /// <param name="count">How many hits.</param>
    public static void Map<R, F, I>(in CompiledCoordinates set, SurfaceBatch<R, F, I> surfaces, FootprintBuffers<R, F, I> footprints, int number, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        int packets = (count + R.Width - 1) / R.Width;
        bool isWorld = set.Mapping.Frame == TextureFrame.World;
        FootprintColumns result = footprints.Sets[number];
        SurfaceSteps<F> steps = footprints.Steps;
        VectorColumns<F> stepX = isWorld ? steps.WorldDx : steps.LocalDx, stepY = isWorld ? steps.WorldDy : steps.LocalDy;

        // The usual mappings are called directly, and their gradients are not written.
        if (set.Mapping is RectangularMapping)
        {
            PointFormulas.Changes<RectangularMapping.Formula, R, F, I>(surfaces.Positions, stepX, stepY, result, packets);
        }
        else if (set.Mapping is SphericalMapping)
        {
            PointFormulas.Changes<SphericalMapping.Formula, R, F, I>(surfaces.Positions, stepX, stepY, result, packets);
        }
        else
        {
            Differentiate(set.Mapping, surfaces, footprints, count);
            Change(footprints.Gradients, stepX, (F*)result.DuDx, (F*)result.DvDx, packets);
            Change(footprints.Gradients, stepY, (F*)result.DuDy, (F*)result.DvDy, packets);
        }

        if (!set.Transform.IsIdentity)
        {
            ApplyTransform(set.Transform, (F*)result.DuDx, (F*)result.DvDx, packets);
            ApplyTransform(set.Transform, (F*)result.DuDy, (F*)result.DvDy, packets);
        }
    }

    /// <summary>Gradients of a mapping.</summary>
    private static void Differentiate<R, F, I>(IMapping mapping, SurfaceBatch<R, F, I> surfaces, FootprintBuffers<R, F, I> footprints, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (mapping is IWideMapping wide)
        {
            int packets = (count + R.Width - 1) / R.Width;
            wide.Gradients(footprints.Narrow(surfaces.Positions, packets, mapping.Frame == TextureFrame.World), footprints.Gradients, packets);
        }
        else
        {
            for (int i = 0; i < count; i++)
            {
                SurfacePosition position = ViewStage.Position(surfaces, i) with { SurfaceGradient = footprints.Steps.SurfaceGradient.Take(i) };
                footprints.Gradients.Put(i, mapping.Gradient(position));
            }
        }
    }

    /// <summary>Takes changes of u and v through a transform.</summary>
    private static void ApplyTransform<F>(UvTransform transform, F* du, F* dv, int packets)
        where F : unmanaged, IReal<F>
    {
        for (int packet = 0; packet < packets; packet++)
        {
            (du[packet], dv[packet]) = transform.ApplyToStep(du[packet], dv[packet]);
        }
    }

    /// <summary>Changes of u and v over steps of the local or of the world point.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Change<F>(in GradientBatch<F> gradients, in VectorColumns<F> steps, F* du, F* dv, int packets)
        where F : unmanaged, IReal<F>
    {
        GradientBatch<F> g = gradients;
        VectorColumns<F> step = steps;
        for (int packet = 0; packet < packets; packet++)
        {
            F x = step.X[packet], y = step.Y[packet], z = step.Z[packet];
            du[packet] = Lane.Dot(g.UX[packet], g.UY[packet], g.UZ[packet], x, y, z);
            dv[packet] = Lane.Dot(g.VX[packet], g.VY[packet], g.VZ[packet], x, y, z);
        }
    }

    /// <summary>The step of a ray's differential in the tangent plane of its hit: q - d (n . q) / (n . d) with q = o' + t d' (Igehy 1999).</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Transfer<F, I>(
        int packet, in LaneRun<I> run, F t, F inverse, in (F X, F Y, F Z) d, in (F X, F Y, F Z) n, in VectorColumns<F> origin, in VectorColumns<F> direction, in VectorColumns<F> result)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F x = F.Fma(t, run.Collect<F, F>(direction.X), run.Collect<F, F>(origin.X));
        F y = F.Fma(t, run.Collect<F, F>(direction.Y), run.Collect<F, F>(origin.Y));
        F z = F.Fma(t, run.Collect<F, F>(direction.Z), run.Collect<F, F>(origin.Z));
        F back = -inverse * Lane.Dot(n.X, n.Y, n.Z, x, y, z);
        result.Store(packet, F.Fma(back, d.X, x), F.Fma(back, d.Y, y), F.Fma(back, d.Z, z));
    }
}
