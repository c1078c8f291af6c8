using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Shadow rays.</content>
internal sealed unsafe partial class LightStage<R, F, I>
{
    private readonly ShadowBounds<R, F, I> _bounds = new(buffers.ShadowRays);

    /// <summary>Tells whether light and shadow rays of a lamp are made in one pass, with cosines.</summary>
    private bool IsUsual(int lamp) => scene.Lights[lamp] is PointLight && scene.IsSkipping;

    /// <summary>The light of one sample of a lamp, and shadow rays to it.</summary>
    private void Aim(int lamp, int sample, int count, int packets)
    {
        if (IsUsual(lamp))
        {
            int aimed = PointShadows.Aim((PointLight)scene.Lights[lamp], buffers, _bounds.Bundles, packets, count);
            counters.ShadowRays += aimed;
            counters.ShadowRaysSkipped += count - aimed;
            buffers.ShadowRays.Bounds = _bounds.Bundles;
            return;
        }

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
