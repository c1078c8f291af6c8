using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Surface points of shapes whose kernel is smooth (<see cref="IShapeKernel.IsSmooth"/>).</summary>
/// <typeparam name="K">The kernel.</typeparam>
[SkipLocalsInit]
internal static unsafe class SmoothSurface<K>
    where K : struct, IShapeKernel
{
    /// <summary>Surface points of hits, columns to columns.</summary>
    /// <param name="rays">The rays.</param>
    /// <param name="t">Their hits' ray parameters, which may become more accurate.</param>
    /// <param name="objects">Their hits' objects.</param>
    /// <param name="numbers">Numbers of all shapes.</param>
    /// <param name="members">The member number of each object; null where there is one member.</param>
    /// <param name="order">Numbers of the rays that hit, padded to whole groups of lanes.</param>
    /// <param name="count">How many.</param>
    /// <param name="to">Where the surface goes.</param>
    /// <param name="needs">Columns that somebody reads.</param>
    /// <returns>How many ray parameters became more accurate.</returns>
    public static int Run<R, F, I>(
        in RayColumns<R> rays, R* t, I* objects, R* numbers, int* members, int* order, int count, in SurfaceColumns<R> to, SurfaceNeeds needs)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        // Eight doubles are two registers of which there are few: half as many lanes at a time stay in them.
        if (typeof(R) == typeof(Double8))
        {
            return Each<Double4, Float4, Int4>(
                Unsafe.As<RayColumns<R>, RayColumns<Double4>>(ref Unsafe.AsRef(in rays)), (Double4*)t, (int*)objects, (Double4*)numbers, members, order, count,
                Unsafe.As<SurfaceColumns<R>, SurfaceColumns<Double4>>(ref Unsafe.AsRef(in to)), needs);
        }

        return Each<R, F, I>(rays, t, (int*)objects, numbers, members, order, count, to, needs);
    }

    private static int Each<R, F, I>(
        in RayColumns<R> rays, R* t, int* objects, R* numbers, int* members, int* order, int count, in SurfaceColumns<R> to, SurfaceNeeds needs)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (members == null && IsQuick(numbers))
        {
            Quick<R, F, I>(rays, t, numbers, order, count, to, needs);
            return 0;
        }

        // Hits whose surface takes more digits are few in most groups of lanes: then they are collected, so that these digits are computed for full ones.
        int* rough = stackalloc int[2 * R.Width];
        int refined = 0, waiting = 0;
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            RayLanes<R> ray = run.Collect<R, F>(rays, t, out R found);
            uint open = members == null
                ? K.Smooth(new SharedParameters<R, F, I>(numbers, 0), ray, found, to, packet, needs)
                : Several<R, F, I>(run, ray, objects, numbers, members, found, to, packet, needs);
            if (BitOperations.PopCount(open) > R.Width / 2)
            {
                refined += Again<R, F, I>(run, ray, t, objects, numbers, members, order, count, to, packet, needs);
                continue;
            }

            for (; open != 0; open &= open - 1)
            {
                rough[waiting] = (packet * R.Width) + BitOperations.TrailingZeroCount(open);
                waiting += rough[waiting] < count ? 1 : 0;
            }

            if (waiting >= R.Width)
            {
                refined += RoughSurface<K>.Run<R, F, I>(rays, t, objects, numbers, members, order, count, rough, R.Width, to, needs);
                waiting -= R.Width;
                new ReadOnlySpan<int>(rough + R.Width, waiting).CopyTo(new Span<int>(rough, waiting));
            }
        }

        return waiting == 0 ? refined : refined + RoughSurface<K>.Run<R, F, I>(rays, t, objects, numbers, members, order, count, rough, waiting, to, needs);
    }

    /// <summary>Tells whether the first shape <see cref="IShapeKernel.IsQuick"/>.</summary>
    private static bool IsQuick<R>(R* numbers)
        where R : unmanaged, IReal<R>
    {
        Span<double> shape = stackalloc double[K.ParameterCount];
        for (int k = 0; k < shape.Length; k++)
        {
            shape[k] = Lane.Take(numbers, k);
        }

        return K.IsQuick(shape);
    }

    /// <summary>Where a group has one shape that is quick.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Quick<R, F, I>(in RayColumns<R> rays, R* t, R* numbers, int* order, int count, in SurfaceColumns<R> to, SurfaceNeeds needs)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        SharedParameters<R, F, I> shape = new(numbers, 0);
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            run.Collect<R, F>(rays.OriginX, rays.OriginY, rays.OriginZ, out R x, out R y, out R z);
            run.Collect<R, F>(rays.DirectionX, rays.DirectionY, rays.DirectionZ, out R dx, out R dy, out R dz);
            K.SmoothQuick(shape, x, y, z, dx, dy, dz, run.Collect<R, F>(t), to, packet, needs);
        }
    }

    /// <summary>Where a group has several shapes: one for all lanes, or a different one in each.</summary>
    private static uint Several<R, F, I>(
        in LaneRun<I> run, in RayLanes<R> ray, int* objects, R* numbers, int* members, in R t, in SurfaceColumns<R> to, int packet, SurfaceNeeds needs)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        int one = objects[run.First];
        I number = run.Collect((I*)objects);
        if (I.AllEqual(number, one))
        {
            return K.Smooth(new SharedParameters<R, F, I>(numbers, members[one] * K.ParameterCount), ray, t, to, packet, needs);
        }

        I first = I.Gather(members, number) * I.Of(K.ParameterCount);
        return K.Smooth(new GatheredParameters<R, F, I>(numbers, first), ray, t, to, packet, needs);
    }
    /// <summary>All of a group of lanes again, most of which are rough.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int Again<R, F, I>(
        in LaneRun<I> run, in RayLanes<R> ray, R* t, int* objects, R* numbers, int* members, int* order, int count, in SurfaceColumns<R> to, int packet, SurfaceNeeds needs)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R exact = run.Collect<R, F>(t);
        int one = objects[run.First];
        I number = run.Collect((I*)objects);
        if (members == null || I.AllEqual(number, one))
        {
            K.SmoothRough(new SharedParameters<R, F, I>(numbers, members == null ? 0 : members[one] * K.ParameterCount), ray, ref exact, to, packet, needs);
        }
        else
        {
            K.SmoothRough(new GatheredParameters<R, F, I>(numbers, I.Gather(members, number) * I.Of(K.ParameterCount)), ray, ref exact, to, packet, needs);
        }

        int from = packet * R.Width, refined = 0;
        for (int lane = 0; lane < R.Width && from + lane < count; lane++)
        {
            double value = R.Get(exact, lane);
            refined += value == R.Take(t, order[from + lane]) ? 0 : 1;
            R.Put(t, order[from + lane], value);
        }

        return refined;
    }
}
