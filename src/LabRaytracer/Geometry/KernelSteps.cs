using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Steps on shapes whose formulas are a kernel.</summary>
internal static unsafe class KernelSteps<K, R, F, I>
    where K : struct, IShapeKernel
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>World space to local space of shapes, in floats: steps are floats.</summary>
    /// <param name="shape">The shapes' numbers.</param>
    /// <param name="frame">The map.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Frame<P>(in P shape, out LinearLanes<F> frame)
        where P : struct, IParameters<R>
    {
        K.LocalFrame(shape, out LinearLanes<R> own);
        frame = new LinearLanes<F>
        {
            XX = R.ToSingle(own.XX), XY = R.ToSingle(own.XY), XZ = R.ToSingle(own.XZ),
            YX = R.ToSingle(own.YX), YY = R.ToSingle(own.YY), YZ = R.ToSingle(own.YZ),
            ZX = R.ToSingle(own.ZX), ZY = R.ToSingle(own.ZY), ZZ = R.ToSingle(own.ZZ),
        };
    }

    /// <summary>Differentiates some groups of lanes.</summary>
    /// <param name="shape">The shapes' numbers.</param>
    /// <param name="toLocal">Their <see cref="Frame"/>.</param>
    /// <param name="first">First group of lanes.</param>
    /// <param name="end">Group of lanes after the last one.</param>
    /// <param name="surfaces">The hits, normals already turned to the viewer.</param>
    /// <param name="steps">Steps in world space; receives what changes over them.</param>
    /// <param name="needs">What somebody reads.</param>
    public static void Run<P>(in P shape, in LinearLanes<F> toLocal, int first, int end, SurfaceBatch<R, F, I> surfaces, SurfaceSteps<F> steps, StepNeeds needs)
        where P : struct, IParameters<R>
    {
        ToLocal(toLocal, first, end, steps.WorldDx, steps.LocalDx);
        ToLocal(toLocal, first, end, steps.WorldDy, steps.LocalDy);
        if ((needs & StepNeeds.Normal) != 0)
        {
            K.LocalFrame(shape, out LinearLanes<R> frame);
            for (int packet = first; packet < end; packet++)
            {
                Bend(shape, frame, packet, surfaces, steps.LocalDx, steps.NormalDx);
                Bend(shape, frame, packet, surfaces, steps.LocalDy, steps.NormalDy);
            }
        }

        if ((needs & StepNeeds.SurfaceGradient) != 0)
        {
            K.SurfaceGradient(shape, out GradientLanes<R> g);
            GradientBatch<F> own = steps.SurfaceGradient;
            for (int packet = first; packet < end; packet++)
            {
                (own.UX[packet], own.UY[packet], own.UZ[packet]) = (R.ToSingle(g.UX), R.ToSingle(g.UY), R.ToSingle(g.UZ));
                (own.VX[packet], own.VY[packet], own.VZ[packet]) = (R.ToSingle(g.VX), R.ToSingle(g.VY), R.ToSingle(g.VZ));
            }
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void ToLocal(in LinearLanes<F> frame, int first, int end, in VectorColumns<F> world, in VectorColumns<F> local)
    {
        F xx = frame.XX, xy = frame.XY, xz = frame.XZ, yx = frame.YX, yy = frame.YY, yz = frame.YZ, zx = frame.ZX, zy = frame.ZY, zz = frame.ZZ;
        for (int packet = first; packet < end; packet++)
        {
            F x = world.X[packet], y = world.Y[packet], z = world.Z[packet];
            local.Store(packet, Lane.Dot(xx, xy, xz, x, y, z), Lane.Dot(yx, yy, yz, x, y, z), Lane.Dot(zx, zy, zz, x, y, z));
        }
    }

    private static void Bend<P>(in P shape, in LinearLanes<R> frame, int packet, SurfaceBatch<R, F, I> surfaces, in VectorColumns<F> local, in VectorColumns<F> result)
        where P : struct, IParameters<R>
    {
        if (!K.IsCurved)
        {
            result.Store(packet, F.Zero, F.Zero, F.Zero);
            return;
        }

        K.BendNormal(
            shape,
            surfaces.Positions.X[packet], surfaces.Positions.Y[packet], surfaces.Positions.Z[packet],
            R.FromSingle(local.X[packet]), R.FromSingle(local.Y[packet]), R.FromSingle(local.Z[packet]), out NormalLanes<R> normal);
        NormalSteps.Store(frame, normal, surfaces, packet, F.True, result);
    }
}
