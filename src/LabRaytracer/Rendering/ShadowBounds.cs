using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Bounds of shadow rays that all end at one point: from bounds of where they start.</summary>
/// <param name="rays">The shadow rays.</param>
internal sealed unsafe class ShadowBounds<R, F, I>(RayBatch<R, F, I> rays)
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const int Bundle = RayBatch<R, F, I>.BundlePackets;

    private readonly RayBounds[] _bounds = new RayBounds[((rays.Capacity / R.Width) / Bundle) + 1];

    /// <summary>Bounds of each bundle.</summary>
    public RayBounds[] Bundles => _bounds;

    /// <summary>Finds bounds of rays to a spot light; null for other lamps. Those of a point light are found where its rays are made (<see cref="PointShadows"/>).</summary>
    /// <param name="light">The lamp.</param>
    public RayBounds[]? Find(Light light)
    {
        if (light is not SpotLight spot)
        {
            return null;
        }

        for (int first = 0; first < rays.Packets; first += Bundle)
        {
            _bounds[first / Bundle] = Find(spot.Position, first, Math.Min(first + Bundle, rays.Packets));
        }

        return _bounds;
    }

    /// <summary>Bounds of a bundle; of rays that are off nothing matters.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private RayBounds Find(Point3D end, int first, int last)
    {
        R leastX = R.Of(double.PositiveInfinity), leastY = leastX, leastZ = leastX;
        R largestX = R.Of(double.NegativeInfinity), largestY = largestX, largestZ = largestX;
        for (int packet = first; packet < last; packet++)
        {
            // All ones is a NaN, of which minima and maxima take the other operand.
            R isOff = ~R.Less(R.Zero, rays.Limit[packet]);
            R x = rays.OriginX[packet] | isOff, y = rays.OriginY[packet] | isOff, z = rays.OriginZ[packet] | isOff;
            leastX = R.Min(x, leastX);
            leastY = R.Min(y, leastY);
            leastZ = R.Min(z, leastZ);
            largestX = R.Max(x, largestX);
            largestY = R.Max(y, largestY);
            largestZ = R.Max(z, largestZ);
        }

        return ShadowBounds.Of(
            end,
            new Point3D(Lane.Least(leastX), Lane.Least(leastY), Lane.Least(leastZ)),
            new Point3D(R.Largest(largestX), R.Largest(largestY), R.Largest(largestZ)));
    }
}

/// <summary>Bounds of rays that all end at one point.</summary>
internal static class ShadowBounds
{
    /// <summary>A little more than the whole way to the lamp.</summary>
    private const double WholeWay = 1 + 1e-6;

    /// <summary>Bounds of rays to a point from inside a box, which is empty if all rays are off.</summary>
    /// <param name="end">Where the rays end.</param>
    /// <param name="least">Least corner of the box.</param>
    /// <param name="largest">Largest corner of the box.</param>
    public static RayBounds Of(Point3D end, Point3D least, Point3D largest) =>
        new(least, largest, end - largest, end - least, 0, least.X <= largest.X ? WholeWay : -1) { Apex = end, Sense = -1 };
}
