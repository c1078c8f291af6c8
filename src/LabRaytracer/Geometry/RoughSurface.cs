using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Surface points that take more digits than those of most hits (<see cref="IShapeKernel.SmoothRough"/>), collected from several groups of lanes.</summary>
/// <typeparam name="K">The kernel.</typeparam>
/// <remarks>Lanes do not look at each other: a hit gets the same bits in whatever company it is computed.</remarks>
[SkipLocalsInit]
internal static unsafe class RoughSurface<K>
    where K : struct, IShapeKernel
{
    /// <summary>Computes some hits of a group again.</summary>
    /// <param name="rays">The rays.</param>
    /// <param name="t">Their hits' ray parameters, which may become more accurate.</param>
    /// <param name="objects">Their hits' objects.</param>
    /// <param name="numbers">Numbers of all shapes.</param>
    /// <param name="members">The member number of each object; null where there is one member.</param>
    /// <param name="order">Numbers of the group's rays.</param>
    /// <param name="count">How many.</param>
    /// <param name="rough">Which of them; room for whole lanes.</param>
    /// <param name="roughs">How many of them, from 1 to the number of lanes.</param>
    /// <param name="to">Where the surface goes. The group of lanes behind the last one is used, too.</param>
    /// <param name="needs">Columns that somebody reads.</param>
    /// <returns>How many ray parameters became more accurate.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static int Run<R, F, I>(
        in RayColumns<R> rays, R* t, int* objects, R* numbers, int* members, int* order, int count, int* rough, int roughs, in SurfaceColumns<R> to, SurfaceNeeds needs)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        for (int pad = roughs; pad < R.Width; pad++)
        {
            rough[pad] = rough[roughs - 1];
        }

        I number = I.Gather(order, I.Load(rough));
        RayLanes<R> ray = new(
            R.Gather(rays.OriginX, number), R.Gather(rays.OriginY, number), R.Gather(rays.OriginZ, number),
            R.Gather(rays.DirectionX, number), R.Gather(rays.DirectionY, number), R.Gather(rays.DirectionZ, number));
        R exact = R.Gather(t, number);
        I first = members == null ? I.Of(0) : I.Gather(members, I.Gather(objects, number)) * I.Of(K.ParameterCount);
        int spare = (count + R.Width - 1) / R.Width;
        K.SmoothRough(new GatheredParameters<R, F, I>(numbers, first), ray, ref exact, to, spare, needs);
        Place(to.Positions, spare * R.Width, rough, roughs, needs);
        int refined = 0;
        for (int lane = 0; lane < roughs; lane++)
        {
            double value = R.Get(exact, lane);
            refined += value == R.Take(t, order[rough[lane]]) ? 0 : 1;
            R.Put(t, order[rough[lane]], value);
        }

        return refined;
    }

    /// <summary>Moves surface points from the lanes in which they were computed to those of their hits.</summary>
    private static void Place<R>(in PositionBatch<R> p, int from, int* rough, int roughs, SurfaceNeeds needs)
        where R : unmanaged, IReal<R>
    {
        Place(new VectorColumns<R>(p.WorldX, p.WorldY, p.WorldZ), from, rough, roughs);
        Place(new VectorColumns<R>(p.WorldNormalX, p.WorldNormalY, p.WorldNormalZ), from, rough, roughs);
        if ((needs & SurfaceNeeds.LocalPoint) != 0)
        {
            Place(new VectorColumns<R>(p.X, p.Y, p.Z), from, rough, roughs);
        }

        if ((needs & SurfaceNeeds.LocalNormal) != 0)
        {
            Place(new VectorColumns<R>(p.NormalX, p.NormalY, p.NormalZ), from, rough, roughs);
        }
    }

    private static void Place<R>(in VectorColumns<R> columns, int from, int* rough, int roughs)
        where R : unmanaged, IReal<R>
    {
        for (int k = 0; k < roughs; k++)
        {
            columns.Put(rough[k], columns.Take(from + k));
        }
    }
}
