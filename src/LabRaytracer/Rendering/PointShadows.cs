using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The usual lamp, a point, in one pass over the hits: its light, the shadow rays to it and their bounds.</summary>
/// <remarks>Rays and bounds have the bits of three passes (<see cref="LightFormulas"/>, then shadow rays, then <see cref="ShadowBounds{R, F, I}"/>); the divisions of one hide the rest.</remarks>
[SkipLocalsInit]
internal static unsafe class PointShadows
{
    /// <summary>Fills the light, with cosines, and the shadow rays of a bundle of hits; where the surface faces away or no light arrives, rays are off and the light is 0.</summary>
    /// <param name="lamp">The lamp.</param>
    /// <param name="buffers">The hits; receives light and rays.</param>
    /// <param name="first">First group of lanes.</param>
    /// <param name="end">Group of lanes after the last one.</param>
    /// <param name="count">Number of all hits: lanes after them only fill their group.</param>
    /// <param name="asksAll">Whether rays are on wherever there is a way to the lamp, though what they find does not matter.</param>
    /// <param name="bounds">Bounds of the rays that are on.</param>
    /// <returns>Number of rays that are on.</returns>
    public static int Aim<R, F, I>(PointLight lamp, ShadingBuffers<R, F, I> buffers, int first, int end, int count, bool asksAll, out RayBounds bounds)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
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

        // Eight doubles are two registers of which there are few: half as many lanes at a time stay in them.
        return typeof(R) == typeof(Double8)
            ? Each<Double4, Float4, Int4>(formula, Unsafe.As<AimColumns<R, F>, AimColumns<Double4, Float4>>(ref columns), 2 * first, 2 * end, count, asksAll, out bounds)
            : Each<R, F, I>(formula, columns, first, end, count, asksAll, out bounds);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int Each<R, F, I>(in PointLight.Formula formula, in AimColumns<R, F> columns, int first, int end, int count, bool asksAll, out RayBounds bounds)
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
            R toX = R.Of(lamp.Position.X) - x, toY = R.Of(lamp.Position.Y) - y, toZ = R.Of(lamp.Position.Z) - z;
            R share = lamp.Share(toX, toY, toZ, out R distance), away = R.Less(R.Zero, distance);
            R lit = away & R.Less(R.Zero, Lane.Dot(nx, ny, nz, toX, toY, toZ));
            if (to.Shading.X != to.Normal.X)
            {
                (nx, ny, nz) = (to.Shading.X[packet], to.Shading.Y[packet], to.Shading.Z[packet]);
                lit &= R.Less(R.Zero, Lane.Dot(nx, ny, nz, toX, toY, toZ));
            }

            F visible = R.MaskToSingle(lit), part = R.ToSingle(share) & visible;
            to.Cosine[packet] = Cosine<R, F, I>(nx, ny, nz, toX, toY, toZ, distance) & visible;
            (to.Intensity.R[packet], to.Intensity.G[packet], to.Intensity.B[packet]) = (red * part, green * part, blue * part);
            to.Direction.Store(packet, R.Select(away, toX / distance, R.Zero), R.Select(away, toY / distance, R.Of(1)), R.Select(away, toZ / distance, R.Zero));
            lit = asksAll ? away : lit;
            R slack = to.Slack[packet];
            x = R.Fma(slack, to.Normal.X[packet], x);
            y = R.Fma(slack, to.Normal.Y[packet], y);
            z = R.Fma(slack, to.Normal.Z[packet], z);
            to.Origin.Store(packet, x, y, z);
            to.Limit[packet] = R.Select(lit, distance, R.Of(-1));
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

    /// <summary>Cosines of the angles between normals and ways to the lamp, in floats, not below 0; of no meaning at the lamp itself.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Cosine<R, F, I>(R normalX, R normalY, R normalZ, R toX, R toY, R toZ, R distance)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        // Rounded to float, quotients and products of doubles are the same numbers but for one in many millions.
        R toUnit = R.Of(1) / distance;
        R x = R.IsSingle ? toX / distance : toX * toUnit, y = R.IsSingle ? toY / distance : toY * toUnit, z = R.IsSingle ? toZ / distance : toZ * toUnit;
        return F.Max(Lane.Dot(R.ToSingle(normalX), R.ToSingle(normalY), R.ToSingle(normalZ), R.ToSingle(x), R.ToSingle(y), R.ToSingle(z)), F.Zero);
    }

    /// <summary>Bits of the lanes that hold hits.</summary>
    /// <param name="left">Number of hits from the first of these lanes on.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Held(int left) => left >= 32 ? uint.MaxValue : left <= 0 ? 0 : (1u << left) - 1;

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
