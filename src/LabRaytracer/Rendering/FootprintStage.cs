using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>What samples cover of surfaces and of texture space, from the differentials of their rays.</summary>
/// <remarks>In float lanes: a footprint decides how much is filtered, not where.</remarks>
internal static unsafe class FootprintStage
{
    /// <summary>
    /// Cosine of the angle between ray and surface below which it counts as this one: rays that graze more have a footprint without end.
    /// </summary>
    private const double LeastCosine = 1e-6;

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
        DifferentialColumns<F> d = rays.Differentials;
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            R approach = Lane.Dot(
                s.NormalX[packet], s.NormalY[packet], s.NormalZ[packet], buffers.DirectionX[packet], buffers.DirectionY[packet], buffers.DirectionZ[packet]);

            // Normals point to the viewer: the product is negative.
            F inverse = R.ToSingle(R.Of(1) / R.Min(approach, R.Of(-LeastCosine)));
            F t = R.ToSingle(run.Collect<R, F>(hits.T));
            Transfer(buffers, packet, run, t, inverse, d.OriginDx, d.DirectionDx, steps.WorldDx);
            Transfer(buffers, packet, run, t, inverse, d.OriginDy, d.DirectionDy, steps.WorldDy);
        }

        group.Differentiate(rays, hits, order, count, memberOfObject, s, steps, needs);
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
        PositionBatch<F> narrow = Narrow(buffers, count, material.ReadsWorld);
        for (int set = 0; set < material.Coordinates.Count; set++)
        {
            if (material.NeedsFootprint(set))
            {
                Map(material.Coordinates[set], narrow, buffers.Surfaces, buffers.Footprints!, set, count);
            }
        }
    }

    /// <summary>Footprints of one coordinate set.</summary>
    /// <param name="set">The set.</param>
    /// <param name="buffers">Positions and steps of the group; receives the footprints.</param>
    /// <param name="number">Number of the set.</param>
    /// <param name="count">How many hits.</param>
    public static void Map<R, F, I>(in CompiledCoordinates set, ShadingBuffers<R, F, I> buffers, int number, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => Map(set, Narrow(buffers, count, set.Mapping.Frame == TextureFrame.World), buffers.Surfaces, buffers.Footprints!, number, count);

    private static PositionBatch<F> Narrow<R, F, I>(ShadingBuffers<R, F, I> buffers, int count, bool hasWorld)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => buffers.Footprints!.Narrow(buffers.Surfaces.Positions, (count + R.Width - 1) / R.Width, hasWorld);

    /// <summary>Changes of one coordinate set over the steps on the surfaces.</summary>
    /// <param name="set">The mapping.</param>
    /// <param name="narrow">Positions rounded to float.</param>
    /// <param name="surfaces">The same as they are.</param>
    /// <param name="footprints">The steps; receives the changes.</param>
    /// <param name="number">Number of the coordinate set.</param>
    /// <param name="count">How many hits.</param>
    public static void Map<R, F, I>(
        in CompiledCoordinates set, in PositionBatch<F> narrow, SurfaceBatch<R, F, I> surfaces, FootprintBuffers<R, F, I> footprints, int number, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        int packets = (count + R.Width - 1) / R.Width;
        if (set.Mapping is IWideMapping wide)
        {
            wide.Gradients(narrow, footprints.Gradients, packets);
        }
        else
        {
            for (int i = 0; i < count; i++)
            {
                SurfacePosition position = ViewStage.Position(surfaces, i) with { SurfaceGradient = footprints.Steps.SurfaceGradient.Take(i) };
                footprints.Gradients.Put(i, set.Mapping.Gradient(position));
            }
        }

        FootprintColumns result = footprints.Sets[number];
        SurfaceSteps<F> steps = footprints.Steps;
        bool isWorld = set.Mapping.Frame == TextureFrame.World;
        Change(footprints.Gradients, isWorld ? steps.WorldDx : steps.LocalDx, set.Transform, (F*)result.DuDx, (F*)result.DvDx, packets);
        Change(footprints.Gradients, isWorld ? steps.WorldDy : steps.LocalDy, set.Transform, (F*)result.DuDy, (F*)result.DvDy, packets);
    }

    /// <summary>Changes of u and v over steps of the local or of the world point.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Change<F>(in GradientBatch<F> gradients, in VectorColumns<F> steps, UvTransform transform, F* du, F* dv, int packets)
        where F : unmanaged, IReal<F>
    {
        GradientBatch<F> g = gradients;
        VectorColumns<F> step = steps;
        bool isTransformed = !transform.IsIdentity;
        for (int packet = 0; packet < packets; packet++)
        {
            F u = Lane.Dot(g.UX[packet], g.UY[packet], g.UZ[packet], step.X[packet], step.Y[packet], step.Z[packet]);
            F v = Lane.Dot(g.VX[packet], g.VY[packet], g.VZ[packet], step.X[packet], step.Y[packet], step.Z[packet]);
            (du[packet], dv[packet]) = isTransformed ? transform.ApplyToStep(u, v) : (u, v);
        }
    }

    /// <summary>The step of a ray's differential in the tangent plane of its hit: q - d (n . q) / (n . d) with q = o' + t d' (Igehy 1999).</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Transfer<R, F, I>(
        ShadingBuffers<R, F, I> buffers, int packet, in LaneRun<I> run, F t, F inverse, in VectorColumns<F> origin, in VectorColumns<F> direction, in VectorColumns<F> result)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        F x = F.Fma(t, run.Collect<F, F>(direction.X), run.Collect<F, F>(origin.X));
        F y = F.Fma(t, run.Collect<F, F>(direction.Y), run.Collect<F, F>(origin.Y));
        F z = F.Fma(t, run.Collect<F, F>(direction.Z), run.Collect<F, F>(origin.Z));
        F back = -inverse * Lane.Dot(R.ToSingle(s.NormalX[packet]), R.ToSingle(s.NormalY[packet]), R.ToSingle(s.NormalZ[packet]), x, y, z);
        result.Store(
            packet,
            F.Fma(back, R.ToSingle(buffers.DirectionX[packet]), x),
            F.Fma(back, R.ToSingle(buffers.DirectionY[packet]), y),
            F.Fma(back, R.ToSingle(buffers.DirectionZ[packet]), z));
    }
}
