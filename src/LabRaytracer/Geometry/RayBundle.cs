using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>What neighbouring rays have in common: bounds of their origins and directions, by which boxes that none of them meets are told from the others at once.</summary>
/// <remarks>
/// Bounds are taken of the rays rounded to float and widened by 2^-22 of each number, four times that rounding. Boxes are widened by 2^-18 of the sum of all
/// coordinates of rays and scene: more than the search for single rays widens them (see <see cref="BvhRay{R, F, I}"/>), so that nothing is left out that it would find.
/// The arithmetic on the bounds is double and its rounding far below that.
/// </remarks>
internal readonly struct RayBundle
{
    private const double RayWidening = 1.0 / (1 << 22);
    private const double BoxWidening = 1.0 / (1 << 18);

    /// <summary>Three coordinates of origins, three of directions.</summary>
    private const int Numbers = 6;

    private readonly BundleAxis _x, _y, _z;
    private readonly double _margin;
    private readonly double _limit;
    private readonly double _factor;

    private RayBundle(BundleAxis x, BundleAxis y, BundleAxis z, double margin, double limit, double factor = 1) =>
        (_x, _y, _z, _margin, _limit, _factor, IsUsable) = (x, y, z, margin, limit, factor, true);

    /// <summary>Tells whether the bounds are finite; of others nothing may be asked.</summary>
    public bool IsUsable { get; }

    /// <summary>Tells whether all rays are off.</summary>
    public bool IsOff => !(_limit > 0);

    /// <summary>Bounds the rays of some groups of lanes that are on.</summary>
    /// <param name="rays">Rays, with their rounded copies written.</param>
    /// <param name="limits">Largest ray parameters; not above 0 for rays that are off.</param>
    /// <param name="first">First group of lanes.</param>
    /// <param name="end">Group of lanes after the last one.</param>
    /// <param name="sceneSize">Sum of the largest coordinates, in magnitude, of the boxes that will be asked about.</param>
    [SkipLocalsInit]
    public static unsafe RayBundle Of<R, F, I>(RayBatch<R, F, I> rays, R* limits, int first, int end, double sceneSize)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F* numbers = stackalloc F[2 * Numbers];
        Include(rays, limits, first, end, numbers, out R limit);
        double last = R.Largest(limit);
        return last > 0 ? Of(numbers, last, sceneSize) : new RayBundle(default, default, default, 0, -1);
    }

    /// <summary>A bundle whose bounds are known.</summary>
    /// <param name="bounds">The bounds.</param>
    /// <param name="sceneSize">Sum of the largest coordinates, in magnitude, of the boxes that will be asked about.</param>
    public static RayBundle Of(in RayBounds bounds, double sceneSize)
    {
        if (!(bounds.Limit > 0))
        {
            return new RayBundle(default, default, default, 0, -1);
        }

        BundleAxis x = Axis(bounds.LeastOrigin.X, bounds.LargestOrigin.X, bounds.LeastDirection.X, bounds.LargestDirection.X, ref sceneSize);
        BundleAxis y = Axis(bounds.LeastOrigin.Y, bounds.LargestOrigin.Y, bounds.LeastDirection.Y, bounds.LargestDirection.Y, ref sceneSize);
        BundleAxis z = Axis(bounds.LeastOrigin.Z, bounds.LargestOrigin.Z, bounds.LeastDirection.Z, bounds.LargestDirection.Z, ref sceneSize);
        return double.IsFinite(sceneSize) ? new RayBundle(x, y, z, sceneSize * BoxWidening, bounds.Limit, bounds.LeastFactor * (1 - RayWidening)) : default;
    }

    /// <summary>Tells whether a ray may meet a box.</summary>
    /// <param name="box">The box.</param>
    /// <param name="start">No ray meets it before this ray parameter; at least 0.</param>
    public bool Meets(in Bounds box, out double start)
    {
        start = 0;
        double end = _limit;
        double minX = box.Min.X - _margin, minY = box.Min.Y - _margin, minZ = box.Min.Z - _margin;
        double maxX = box.Max.X + _margin, maxY = box.Max.Y + _margin, maxZ = box.Max.Z + _margin;
        _x.Narrow(minX, maxX, ref start, ref end);
        _y.Narrow(minY, maxY, ref start, ref end);
        _z.Narrow(minZ, maxZ, ref start, ref end);

        // Rounded to float, it must not come after the first ray.
        start *= 1 - RayWidening;
        bool isInTime = start <= end;
        start *= _factor;
        return isInTime && _x.Meets(minX, maxX, end) && _y.Meets(minY, maxY, end) && _z.Meets(minZ, maxZ, end);
    }

    /// <summary>Bounds of each lane: the least numbers, then the largest ones.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static unsafe void Include<R, F, I>(RayBatch<R, F, I> rays, R* limits, int first, int end, F* bounds, out R limit)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        F above = F.Of(double.PositiveInfinity), below = F.Of(double.NegativeInfinity);
        (F leastX, F leastY, F leastZ, F largestX, F largestY, F largestZ) = (above, above, above, below, below, below);
        R largest = R.Of(-1);
        (F lowX, F lowY, F lowZ, F highX, F highY, F highZ) = (above, above, above, below, below, below);
        for (int packet = first; packet < end; packet++)
        {
            largest = R.Max(limits[packet], largest);
            F isOff = ~R.MaskToSingle(R.Less(R.Zero, limits[packet]));
            RayLanes<F> ray = rays.LoadSingle(packet);

            // The order of operands keeps what is known where a number is NaN: such a ray meets nothing. So does the one that is off, all ones being a NaN.
            Widen(ray.OriginX | isOff, ref leastX, ref largestX);
            Widen(ray.OriginY | isOff, ref leastY, ref largestY);
            Widen(ray.OriginZ | isOff, ref leastZ, ref largestZ);
            Widen(ray.DirectionX | isOff, ref lowX, ref highX);
            Widen(ray.DirectionY | isOff, ref lowY, ref highY);
            Widen(ray.DirectionZ | isOff, ref lowZ, ref highZ);
        }

        limit = largest;
        (bounds[0], bounds[1], bounds[2], bounds[3], bounds[4], bounds[5]) = (leastX, leastY, leastZ, lowX, lowY, lowZ);
        (bounds[6], bounds[7], bounds[8], bounds[9], bounds[10], bounds[11]) = (largestX, largestY, largestZ, highX, highY, highZ);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Widen<F>(F number, ref F least, ref F largest)
        where F : unmanaged, IReal<F>
    {
        least = F.Min(number, least);
        largest = F.Max(number, largest);
    }

    private static unsafe RayBundle Of<F>(F* bounds, double limit, double sceneSize)
        where F : unmanaged, IReal<F>
    {
        BundleAxis x = Axis(bounds, ref sceneSize), y = Axis(bounds + 1, ref sceneSize), z = Axis(bounds + 2, ref sceneSize);
        return double.IsFinite(sceneSize) ? new RayBundle(x, y, z, sceneSize * BoxWidening, limit) : default;
    }

    /// <summary>One axis of the bounds, widened.</summary>
    private static unsafe BundleAxis Axis<F>(F* bounds, ref double size)
        where F : unmanaged, IReal<F> =>
        Axis(Lane.Least(bounds[0]), F.Largest(bounds[Numbers]), Lane.Least(bounds[3]), F.Largest(bounds[Numbers + 3]), ref size);

    private static BundleAxis Axis(double from, double to, double slowest, double fastest, ref double size)
    {
        from -= Math.Abs(from) * RayWidening;
        to += Math.Abs(to) * RayWidening;
        size += Math.Max(Math.Abs(from), Math.Abs(to));
        return new BundleAxis(from, to, slowest - (Math.Abs(slowest) * RayWidening), fastest + (Math.Abs(fastest) * RayWidening));
    }
}
