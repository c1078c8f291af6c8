using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The formulas of <see cref="Torus"/>: centre x, y, z, radius of the ring and of the tube.</summary>
internal readonly struct TorusKernel : IShapeKernel
{
    private const int CenterX = 0, CenterY = 1, CenterZ = 2, Ring = 3, Tube = 4;

    public static int ParameterCount => 5;

    public static bool IsCurved => true;

    public static void Describe(Shape shape, Transform transform, Span<double> numbers)
    {
        Torus torus = (Torus)shape;
        numbers[CenterX] = torus.Center.X;
        numbers[CenterY] = torus.Center.Y;
        numbers[CenterZ] = torus.Center.Z;
        numbers[Ring] = torus.RingRadius;
        numbers[Tube] = torus.TubeRadius;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Intersect<R, P>(in P shape, in RayLanes<R> ray, out R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        R hit = Locate(shape, ray, centred, out R along);
        t = centred.K + along;
        return hit & R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity));
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    public static R Refine<R, P>(in P shape, in RayLanes<R> ray, R t)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        Locate(shape, ray, centred, out R along);
        PreciseTorusHit<R> hit = new(Line(shape, ray, centred.K), ray, shape[Ring], shape[Tube], along);
        return hit.T;
    }

    /// <remarks>The point is put back onto the tube along the normal.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Surface<R, P>(in P shape, in RayLanes<R> ray, ref R t, out SurfaceLanes<R> s)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R ring = shape[Ring], tube = shape[Tube];
        CentredRay<R>.Of(ray, shape, CenterX, out CentredRay<R> centred);
        Locate(shape, ray, centred, out R along);
        PreciseTorusHit<R> hit = new(Line(shape, ray, centred.K), ray, ring, tube, along);
        t = hit.T;
        R toAxis = R.Of(1) / R.Sqrt(R.Fma(hit.X, hit.X, hit.Z * hit.Z));
        R sin = hit.X * toAxis, cos = hit.Z * toAxis;
        R toTube = R.Of(1) / R.Sqrt(R.Fma(hit.Outward, hit.Outward, hit.Y * hit.Y));
        R outward = hit.Outward * toTube, up = hit.Y * toTube;
        R share = tube / ring, distance = R.Fma(share, outward, R.Of(1));
        s = default;
        s.LocalX = distance * sin;
        s.LocalY = share * up;
        s.LocalZ = distance * cos;
        s.NormalX = s.ShadingX = s.LocalNormalX = outward * sin;
        s.NormalY = s.ShadingY = s.LocalNormalY = up;
        s.NormalZ = s.ShadingZ = s.LocalNormalZ = outward * cos;
        s.PointX = R.Fma(ring, s.LocalX, shape[CenterX]);
        s.PointY = R.Fma(tube, up, shape[CenterY]);
        s.PointZ = R.Fma(ring, s.LocalZ, shape[CenterZ]);
        s.Slack = Lane.Slack(R.Abs(shape[CenterX]) + R.Abs(shape[CenterY]) + R.Abs(shape[CenterZ]) + ring + tube);
    }

    /// <summary>Steps from the nearest point l to the first hit ahead.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static R Locate<R, P>(in P shape, in RayLanes<R> ray, in CentredRay<R> centred, out R along)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        TorusLine<R> line = new(centred, shape[Ring], shape[Tube]);
        TorusBrackets<R> brackets = new(line, centred.K);
        if (!R.Any(brackets.IsNear))
        {
            along = R.Zero;
            return R.Zero;
        }

        if (R.Any(brackets.IsClose))
        {
            PreciseLine<R> precise = Line(shape, ray, centred.K);
            brackets.Decide(line, precise, ray, shape[Ring], shape[Tube]);
        }

        R hit = brackets.First(out R low, out R high, out R startsInside);
        along = line.Along(TorusRoot.Find(line, hit, low, high, startsInside));
        return hit;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static PreciseLine<R> Line<R, P>(in P shape, in RayLanes<R> ray, R k)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R> => new(ray, shape[CenterX], shape[CenterY], shape[CenterZ], k);

    public static void LocalFrame<R, P>(in P shape, out LinearLanes<R> frame)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R scale = R.Of(1) / shape[Ring];
        frame = LinearLanes<R>.Scaling(scale, scale, scale);
    }

    /// <remarks>The way from the nearest point of the ring: p - (x, 0, z) / rho.</remarks>
    public static void BendNormal<R, P>(in P shape, R x, R y, R z, R stepX, R stepY, R stepZ, out NormalLanes<R> normal)
        where R : unmanaged, IReal<R>
        where P : struct, IParameters<R>
    {
        R inverse = R.Of(1) / R.Sqrt(R.Fma(x, x, z * z)), share = R.Of(1) - inverse;
        R change = R.Fma(x, stepX, z * stepZ) * inverse * inverse * inverse;
        normal = new NormalLanes<R>
        {
            X = x * share, Y = y, Z = z * share, StepX = R.Fma(stepX, share, x * change), StepY = stepY, StepZ = R.Fma(stepZ, share, z * change),
        };
    }
}
