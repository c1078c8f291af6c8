using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The usual lamp, a point, in one pass over the hits: its light, the shadow rays to it and their bounds.</summary>
/// <remarks>The bits of three passes (<see cref="LightFormulas"/>, then shadow rays, then <see cref="ShadowBounds{R, F, I}"/>); the divisions of one hide the rest.</remarks>
[SkipLocalsInit]
internal static unsafe class PointShadows
{
    /// <summary>Fills the light, with cosines, and the shadow rays of a group of hits; rays are off where the surface faces away or no light arrives.</summary>
    /// <param name="lamp">The lamp.</param>
    /// <param name="buffers">The hits; receives light and rays.</param>
    /// <param name="bounds">Receives bounds of the rays, bundle by bundle.</param>
    /// <param name="packets">Groups of lanes.</param>
    /// <param name="count">Number of hits.</param>
    /// <returns>Number of rays that are on.</returns>
    public static int Aim<R, F, I>(PointLight lamp, ShadingBuffers<R, F, I> buffers, RayBounds[] bounds, int packets, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        const int Bundle = RayBatch<R, F, I>.BundlePackets;
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        LightColumns<R, F> light = buffers.Light;
        RayBatch<R, F, I> rays = buffers.ShadowRays;
        AimColumns<R, F> columns = new(
            new(s.PointX, s.PointY, s.PointZ),
            new(s.NormalX, s.NormalY, s.NormalZ),
            new(s.ShadingX, s.ShadingY, s.ShadingZ),
            s.Slack,
            new(light.DirectionX, light.DirectionY, light.DirectionZ),
            light.Intensity,
            light.Cosine,
            new(rays.OriginX, rays.OriginY, rays.OriginZ),
            rays.Limit);
        PointLight.Formula formula = lamp.Own;
        int aimed = 0;
        for (int first = 0; first < packets; first += Bundle)
        {
            int end = Math.Min(first + Bundle, packets);

            // Eight doubles are two registers of which there are few: half as many lanes at a time stay in them.
            aimed += typeof(R) == typeof(Double8)
                ? Each<Double4, Float4, Int4>(
                    formula, Unsafe.As<AimColumns<R, F>, AimColumns<Double4, Float4>>(ref columns), 2 * first, 2 * end, count, out bounds[first / Bundle])
                : Each<R, F, I>(formula, columns, first, end, count, out bounds[first / Bundle]);
        }

        rays.Count = packets * R.Width;
        return aimed;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int Each<R, F, I>(in PointLight.Formula formula, in AimColumns<R, F> columns, int first, int end, int count, out RayBounds bounds)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        AimColumns<R, F> to = columns;
        PointLight.Formula lamp = formula;
        R leastX = R.Of(double.PositiveInfinity), leastY = leastX, leastZ = leastX;
        R largestX = R.Of(double.NegativeInfinity), largestY = largestX, largestZ = largestX;
        F red = F.Of(lamp.Intensity.R), green = F.Of(lamp.Intensity.G), blue = F.Of(lamp.Intensity.B);
        int aimed = 0;
        for (int packet = first; packet < end; packet++)
        {
            R x = to.Point.X[packet], y = to.Point.Y[packet], z = to.Point.Z[packet];
            R nx = to.Normal.X[packet], ny = to.Normal.Y[packet], nz = to.Normal.Z[packet];
            lamp.Sample(x, y, z, out LightLanes<R> light);
            to.Direction.Store(packet, light.DirectionX, light.DirectionY, light.DirectionZ);
            F share = R.ToSingle(light.Share), r = red * share, g = green * share, b = blue * share;
            (to.Intensity.R[packet], to.Intensity.G[packet], to.Intensity.B[packet]) = (r, g, b);
            R lit = R.MaskFromSingle(F.Less(F.Zero, F.Max(r, F.Max(g, b)))) & R.Less(R.Zero, Lane.Dot(nx, ny, nz, light.DirectionX, light.DirectionY, light.DirectionZ));
            F tiltX = R.ToSingle(nx), tiltY = R.ToSingle(ny), tiltZ = R.ToSingle(nz);
            if (to.Shading.X != to.Normal.X)
            {
                R sx = to.Shading.X[packet], sy = to.Shading.Y[packet], sz = to.Shading.Z[packet];
                lit &= R.Less(R.Zero, Lane.Dot(sx, sy, sz, light.DirectionX, light.DirectionY, light.DirectionZ));
                (tiltX, tiltY, tiltZ) = (R.ToSingle(sx), R.ToSingle(sy), R.ToSingle(sz));
            }

            to.Cosine[packet] = F.Max(
                Lane.Dot(tiltX, tiltY, tiltZ, R.ToSingle(light.DirectionX), R.ToSingle(light.DirectionY), R.ToSingle(light.DirectionZ)), F.Zero);
            R slack = to.Slack[packet];
            x = R.Fma(slack, nx, x);
            y = R.Fma(slack, ny, y);
            z = R.Fma(slack, nz, z);
            to.Origin.Store(packet, x, y, z);
            to.Limit[packet] = R.Select(lit, light.Distance, R.Of(-1));
            aimed += BitOperations.PopCount(R.Bits(lit) & Held(count - (packet * R.Width)));

            // All ones is a NaN, of which minima and maxima take the other operand.
            R isOff = ~lit;
            leastX = R.Min(x | isOff, leastX);
            leastY = R.Min(y | isOff, leastY);
            leastZ = R.Min(z | isOff, leastZ);
            largestX = R.Max(x | isOff, largestX);
            largestY = R.Max(y | isOff, largestY);
            largestZ = R.Max(z | isOff, largestZ);
        }

        bounds = ShadowBounds.Of(
            lamp.Position,
            new Point3D(Lane.Least(leastX), Lane.Least(leastY), Lane.Least(leastZ)),
            new Point3D(R.Largest(largestX), R.Largest(largestY), R.Largest(largestZ)));
        return aimed;
    }

    /// <summary>Bits of the lanes that hold hits.</summary>
    /// <param name="left">Number of hits from the first of these lanes on.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Held(int left) => left >= 32 ? uint.MaxValue : left <= 0 ? 0 : (1u << left) - 1;

    /// <summary>What is read and written.</summary>
    private readonly struct AimColumns<R, F>(
        VectorColumns<R> point, VectorColumns<R> normal, VectorColumns<R> shading, R* slack, VectorColumns<R> direction, ColorColumns<F> intensity, F* cosine,
        VectorColumns<R> origin, R* limit)
        where R : unmanaged, IReal<R>
        where F : unmanaged, IReal<F>
    {
        public readonly VectorColumns<R> Point = point, Normal = normal, Shading = shading;
        public readonly R* Slack = slack;
        public readonly VectorColumns<R> Direction = direction;
        public readonly ColorColumns<F> Intensity = intensity;
        public readonly F* Cosine = cosine;
        public readonly VectorColumns<R> Origin = origin;
        public readonly R* Limit = limit;
    }
}
