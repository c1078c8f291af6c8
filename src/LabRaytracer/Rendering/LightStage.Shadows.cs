using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Shadow rays.</content>
internal sealed unsafe partial class LightStage<R, F, I>
{
    private const int Bundle = RayBatch<R, F, I>.BundlePackets;

    private readonly ShadowBounds<R, F, I> _bounds = new(buffers.ShadowRays);
    private readonly HitBounds<R, F, I> _hits = new(buffers.ShadowRays.Capacity);

    /// <summary>A lamp at a point, bundle after bundle: light straight away where nothing can be in its way, after shadow rays elsewhere.</summary>
    private void AddPoint(PointLight lamp, CompiledMaterial material, int* order, int count, int packets)
    {
        RayBatch<R, F, I> rays = buffers.ShadowRays;
        if (scene.IsSkipping && lamp.Intensity == Intensity.Black)
        {
            counters.ShadowRaysSkipped += count;
            return;
        }

        // What looks at every ray on its way sees all of them at once.
        bool isByBundle = scene.IsSkipping && tally is null && alpha is null, isMatte = isByBundle && MatteLight.IsMatte(material);
        int common = rays.CommonSource, aimed = 0;
        rays.Count = packets * R.Width;
        rays.Bounds = scene.IsSkipping ? _bounds.Bundles : null;
        rays.Renew();
        BundleCandidate* blockers = stackalloc BundleCandidate[SceneBvh<R, F, I>.MostBlockers];
        for (int first = 0; first < packets; first += Bundle)
        {
            int bundle = first / Bundle, end = Math.Min(first + Bundle, packets);
            int found = isByBundle ? FindBlockers(lamp, bundle, blockers) : -1;
            if (isMatte && found == 0)
            {
                aimed += OpenLight.Add(lamp, material, buffers, first, end, count);
                continue;
            }

            aimed += PointShadows.Aim(lamp, buffers, first, end, count, !scene.IsSkipping, out _bounds.Bundles[bundle]);
            if (isByBundle && found != 0)
            {
                rays.CommonSource = _hits.Source(bundle);
                scene.Block(rays, first, end, blockers, found);
            }

            if (isMatte)
            {
                MatteLight.Add(material, buffers, first, end, isKnown: true);
            }
        }

        rays.CommonSource = common;
        counters.ShadowRays += aimed;
        counters.ShadowRaysSkipped += count - aimed;
        tally?.Add(rays, order, count);
        if (!isByBundle)
        {
            Block(lamp, 0, packets);
        }

        if (!isMatte)
        {
            Reflect(material, packets, count, knowsCosines: true);
        }
    }

    /// <summary>Lists what may be between a lamp and the hits of a bundle; -1 where that is much.</summary>
    private int FindBlockers(PointLight lamp, int bundle, BundleCandidate* found) =>
        lamp.CastsShadows ? scene.FindBlockers(_hits.To(bundle, lamp.Position), _hits.Source(bundle), found) : 0;

    /// <summary>Turns off, or dims, the shadow rays that something is in the way of.</summary>
    private void Block(Light lamp, int first, int end)
    {
        if (lamp.CastsShadows)
        {
            scene.Block(buffers.ShadowRays, first, end);
            alpha?.Run(buffers.ShadowRays, buffers.Light.Intensity);
        }
    }

    /// <summary>The light of one sample of a lamp, and shadow rays to it.</summary>
    private void Aim(int lamp, int sample, int count, int packets)
    {
        lamps.Sample(lamp, sample, count, packets);
        AimShadowRays(packets, count);
        buffers.ShadowRays.Bounds = scene.IsSkipping ? _bounds.Find(scene.Lights[lamp]) : null;
    }

    /// <summary>Mask of the hits that a lamp can light.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private R IsReached(int packet)
    {
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        LightColumns<R, F> light = buffers.Light;
        R lx = light.DirectionX[packet], ly = light.DirectionY[packet], lz = light.DirectionZ[packet];
        R geometric = Lane.Dot(s.NormalX[packet], s.NormalY[packet], s.NormalZ[packet], lx, ly, lz);
        R reached = R.Less(R.Zero, geometric);
        if (!s.SharesNormals)
        {
            reached &= R.Less(R.Zero, Lane.Dot(s.ShadingX[packet], s.ShadingY[packet], s.ShadingZ[packet], lx, ly, lz));
        }

        F most = F.Max(light.Intensity.R[packet], F.Max(light.Intensity.G[packet], light.Intensity.B[packet]));
        return reached & R.MaskFromSingle(F.Less(F.Zero, most));
    }

    /// <summary>Turns off the shadow rays that were only followed because nothing is skipped.</summary>
    private void Forget(int packets)
    {
        R* limit = buffers.ShadowRays.Limit;
        for (int packet = 0; packet < packets; packet++)
        {
            limit[packet] = R.Select(IsReached(packet), limit[packet], R.Of(-1));
        }
    }

    /// <summary>Rays from outside the hit's slack to the lamp; off where the surface faces away or no light arrives.</summary>
    private void AimShadowRays(int packets, int count)
    {
        RayBatch<R, F, I> rays = buffers.ShadowRays;
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        LightColumns<R, F> light = buffers.Light;
        rays.Count = packets * R.Width;
        int aimed = 0;
        for (int packet = 0; packet < packets; packet++)
        {
            R lit = scene.IsSkipping ? IsReached(packet) : R.True;
            R slack = s.Slack[packet];
            rays.OriginX[packet] = R.Fma(slack, s.NormalX[packet], s.PointX[packet]);
            rays.OriginY[packet] = R.Fma(slack, s.NormalY[packet], s.PointY[packet]);
            rays.OriginZ[packet] = R.Fma(slack, s.NormalZ[packet], s.PointZ[packet]);
            rays.Limit[packet] = R.Select(lit, light.Distance[packet], R.Of(-1));
            uint live = R.Bits(lit);
            aimed += BitOperations.PopCount(packet == packets - 1 ? live & Tail(count) : live);
        }

        counters.ShadowRays += aimed;
        counters.ShadowRaysSkipped += count - aimed;
    }

    /// <summary>Bits of the lanes of the last group that hold hits.</summary>
    private static uint Tail(int count) => count % R.Width == 0 ? uint.MaxValue : (1u << (count % R.Width)) - 1;
}
