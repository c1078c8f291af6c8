using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>What the hits of a bundle have in common, whatever the lamp: where their shadow rays start, and the surface that these leave.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <typeparam name="F">Float lanes of the same width.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
[SkipLocalsInit]
internal sealed unsafe class HitBounds<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const int Bundle = RayBatch<R, F, I>.BundlePackets;

    private readonly (Point3D Least, Point3D Largest)[] _boxes;
    private readonly int[] _sources;

    /// <param name="capacity">Most hits.</param>
    public HitBounds(int capacity)
    {
        int bundles = (capacity / R.Width / Bundle) + 1;
        _boxes = new (Point3D Least, Point3D Largest)[bundles];
        _sources = new int[bundles];
    }

    /// <summary>Number of the object whose outer side all shadow rays of a bundle leave, or -1.</summary>
    public int Source(int bundle) => _sources[bundle];

    /// <summary>Bounds of all rays of a bundle to a point.</summary>
    /// <param name="bundle">Which bundle.</param>
    /// <param name="end">Where the rays end.</param>
    public RayBounds To(int bundle, Point3D end) => ShadowBounds.Of(end, _boxes[bundle].Least, _boxes[bundle].Largest);

    /// <summary>Finds them for a group of hits.</summary>
    /// <param name="surfaces">The hits.</param>
    /// <param name="sources">Number of the object whose outer side the shadow ray of each hit leaves, or -1.</param>
    /// <param name="packets">Groups of lanes.</param>
    public void Find(SurfaceBatch<R, F, I> surfaces, I* sources, int packets)
    {
        VectorColumns<R> points = new(surfaces.PointX, surfaces.PointY, surfaces.PointZ);
        for (int first = 0; first < packets; first += Bundle)
        {
            int end = Math.Min(first + Bundle, packets);
            _boxes[first / Bundle] = Box(points, surfaces.Slack, first, end);
            _sources[first / Bundle] = Common(sources, first, end);
        }
    }

    /// <summary>The box around the points, and around all that is within their slack: shadow rays start there.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static (Point3D Least, Point3D Largest) Box(VectorColumns<R> points, R* slacks, int first, int end)
    {
        R leastX = R.Of(double.PositiveInfinity), leastY = leastX, leastZ = leastX;
        R largestX = R.Of(double.NegativeInfinity), largestY = largestX, largestZ = largestX;
        for (int packet = first; packet < end; packet++)
        {
            R x = points.X[packet], y = points.Y[packet], z = points.Z[packet], slack = slacks[packet];
            leastX = R.Min(x - slack, leastX);
            leastY = R.Min(y - slack, leastY);
            leastZ = R.Min(z - slack, leastZ);
            largestX = R.Max(x + slack, largestX);
            largestY = R.Max(y + slack, largestY);
            largestZ = R.Max(z + slack, largestZ);
        }

        return (
            new Point3D(Lane.Least(leastX), Lane.Least(leastY), Lane.Least(leastZ)),
            new Point3D(R.Largest(largestX), R.Largest(largestY), R.Largest(largestZ)));
    }

    private static int Common(I* sources, int first, int end)
    {
        int source = *(int*)(sources + first);
        for (int packet = first; packet < end; packet++)
        {
            if (!I.AllEqual(sources[packet], source))
            {
                return -1;
            }
        }

        return source;
    }
}
