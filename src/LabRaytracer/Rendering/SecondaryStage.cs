using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Reflected and refracted rays of a group of hits (Whitted 1980).</summary>
[SkipLocalsInit]
internal sealed unsafe class SecondaryStage<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>
    /// A ray of less weight than this in every channel is not followed: light of up to 4 times display white that it brings
    /// then changes an 8-bit linear code value by less than 1/4.
    /// </summary>
    public const float LeastWeight = 1f / 4096;

    private readonly ShadingBuffers<R, F, I> _buffers;
    private readonly SecondaryRays<R, F, I> _secondary;
    private readonly WorkerCounters _counters;
    private readonly bool _isSkipping;
    private readonly SecondaryColumns<R, F, I> _reflected;
    private readonly SecondaryColumns<R, F, I> _refracted;

    public SecondaryStage(ShadingBuffers<R, F, I> buffers, SecondaryRays<R, F, I> secondary, WorkerCounters counters, LaneMemory memory, int capacity, bool isSkipping)
    {
        _buffers = buffers;
        _secondary = secondary;
        _counters = counters;
        _isSkipping = isSkipping;
        _reflected = new SecondaryColumns<R, F, I>(memory, capacity, buffers.Footprints is not null);
        _refracted = new SecondaryColumns<R, F, I>(memory, capacity, buffers.Footprints is not null);
    }

    /// <summary>Makes the secondary rays of a group.</summary>
    /// <param name="material">The material, which mirrors or transmits.</param>
    /// <param name="rays">The rays.</param>
    /// <param name="order">Numbers of the rays that hit.</param>
    /// <param name="count">How many.</param>
    /// <param name="weights">Weight of each ray of the batch.</param>
    /// <param name="pixels">Pixel of each ray of the batch.</param>
    public void Run(CompiledMaterial material, RayBatch<R, F, I> rays, int* order, int count, in ColorColumns<F> weights, I* pixels)
    {
        bool isTransparent = !material.Transparency.IsBlack;
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            material.Reflection.Read(_buffers.Texels, packet, out F red, out F green, out F blue);
            if (isTransparent)
            {
                Refract(material, packet, ref red, ref green, ref blue);
            }

            _reflected.SetShare(packet, red, green, blue);
            Reflect(packet);
        }

        if (_buffers.Footprints is not null)
        {
            Differentiate(material, rays, order, count);
        }

        for (int packet = 0; packet * R.Width < count; packet++)
        {
            int first = packet * R.Width;
            LaneRun<I> run = new(order, first, count);
            uint held = uint.MaxValue >> (32 - Math.Min(R.Width, count - first));
            if (Follow(_reflected, packet, run, weights, held) is not 0 and uint reflected)
            {
                _reflected.Pixel[packet] = run.Collect(pixels);
                _reflected.Source[packet] = _buffers.ShadowRays.Source[packet];
                _secondary.Reflect(order + first, reflected, _secondary.Queue.Arise(_reflected, packet, reflected));
            }

            if (isTransparent && Follow(_refracted, packet, run, weights, held) is not 0 and uint refracted)
            {
                _refracted.Pixel[packet] = run.Collect(pixels);
                _refracted.Source[packet] = I.Of(-1);
                _secondary.Refract(order + first, refracted, _secondary.Queue.Arise(_refracted, packet, refracted));
            }
        }
    }

    /// <summary>Makes weights of shares, and chooses the rays that are followed.</summary>
    /// <param name="rays">Reflected or refracted rays.</param>
    /// <param name="packet">Group of lanes.</param>
    /// <param name="run">The rays that they come from.</param>
    /// <param name="weights">Weight of each ray of the batch.</param>
    /// <param name="held">Bits of the lanes that hold hits.</param>
    /// <returns>Bits of the lanes that are followed. The weight is black where that is only so because nothing is skipped.</returns>
    private uint Follow(SecondaryColumns<R, F, I> rays, int packet, in LaneRun<I> run, in ColorColumns<F> weights, uint held)
    {
        run.Collect<F, F>(weights.R, weights.G, weights.B, out F red, out F green, out F blue);
        red *= rays.Weight.R[packet];
        green *= rays.Weight.G[packet];
        blue *= rays.Weight.B[packet];
        F most = F.Max(red, F.Max(green, blue)), isNumber = F.Equal(red, red) & F.Equal(green, green) & F.Equal(blue, blue);
        F isStrong = isNumber & F.LessOrEqual(F.Of(LeastWeight), most);
        uint strong = F.Bits(isStrong) & held, faint = F.Bits(isNumber & F.Less(F.Zero, most)) & held & ~strong;
        _counters.SecondaryRays += BitOperations.PopCount(strong);
        if (faint == 0 || _isSkipping)
        {
            _counters.SecondaryRaysSkipped += BitOperations.PopCount(faint);
            rays.SetShare(packet, red, green, blue);
            return strong;
        }

        _counters.SecondaryRays += BitOperations.PopCount(faint);
        rays.SetShare(packet, red & isStrong, green & isStrong, blue & isStrong);
        return strong | faint;
    }

    /// <summary>Refracted rays; what the boundary mirrors instead is added to the reflected shares.</summary>
    private void Refract(CompiledMaterial material, int packet, ref F red, ref F green, ref F blue)
    {
        SurfaceBatch<R, F, I> s = _buffers.Surfaces;
        material.Transparency.Read(_buffers.Texels, packet, out F tr, out F tg, out F tb);
        R one = R.Of(1);
        R index = R.FromSingle(material.IndexOfRefraction.Read(_buffers.Texels, packet));
        R ratio = R.Select(_buffers.Inside[packet], index, one / index);
        R dx = _buffers.DirectionX[packet], dy = _buffers.DirectionY[packet], dz = _buffers.DirectionZ[packet];
        R nx = s.ShadingX[packet], ny = s.ShadingY[packet], nz = s.ShadingZ[packet];
        R cosNear = R.Min(R.Max(-Lane.Dot(dx, dy, dz, nx, ny, nz), R.Zero), one);
        R sinSquared = ratio * ratio * (one - (cosNear * cosNear));
        R leaves = R.Less(sinSquared, one);
        R cosFar = R.Sqrt(R.Max(one - sinSquared, R.Zero));
        R mirrored = material.Material.Fresnel switch
        {
            FresnelModel.Dielectric => Fresnel.Dielectric(ratio, cosNear, cosFar),
            FresnelModel.Schlick => Fresnel.Schlick(ratio, cosNear, cosFar),
            _ => R.Zero,
        };

        // Total reflection: nothing leaves through the surface.
        mirrored = R.Select(leaves, mirrored, one);
        F through = R.ToSingle(one - mirrored), back = R.ToSingle(mirrored);
        _refracted.SetShare(packet, tr * through, tg * through, tb * through);
        red += tr * back;
        green += tg * back;
        blue += tb * back;
        R along = (ratio * cosNear) - cosFar;
        _refracted.SetRay(
            packet, s, -s.Slack[packet], R.Fma(dx, ratio, nx * along), R.Fma(dy, ratio, ny * along), R.Fma(dz, ratio, nz * along));
    }

    private void Reflect(int packet)
    {
        SurfaceBatch<R, F, I> s = _buffers.Surfaces;
        R dx = _buffers.DirectionX[packet], dy = _buffers.DirectionY[packet], dz = _buffers.DirectionZ[packet];
        R nx = s.ShadingX[packet], ny = s.ShadingY[packet], nz = s.ShadingZ[packet];
        R twice = R.Of(-2) * Lane.Dot(dx, dy, dz, nx, ny, nz);
        R x = R.Fma(twice, nx, dx), y = R.Fma(twice, ny, dy), z = R.Fma(twice, nz, dz);

        // An interpolated normal can mirror into the surface: the ray is bent back to the near side of the horizon.
        R gx = s.NormalX[packet], gy = s.NormalY[packet], gz = s.NormalZ[packet];
        R above = Lane.Dot(x, y, z, gx, gy, gz);
        R lift = R.Select(R.Less(R.Zero, above), R.Zero, R.Of(1e-4) - above);
        _reflected.SetRay(packet, s, s.Slack[packet], R.Fma(lift, gx, x), R.Fma(lift, gy, y), R.Fma(lift, gz, z));
    }

    /// <summary>How the secondary rays change from sample to sample: they start on the steps of their hits.</summary>
    private void Differentiate(CompiledMaterial material, RayBatch<R, F, I> rays, int* order, int count)
    {
        SurfaceSteps<F> steps = _buffers.Footprints!.Steps;
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            LaneRun<I> run = new(order, packet * R.Width, count);
            Differentiate(material, packet, run, rays.Differentials.DirectionDx, steps.WorldDx, steps.NormalDx, isDown: false);
            Differentiate(material, packet, run, rays.Differentials.DirectionDy, steps.WorldDy, steps.NormalDy, isDown: true);
        }
    }

    private void Differentiate(
        CompiledMaterial material, int packet, in LaneRun<I> run, in VectorColumns<F> turn, in VectorColumns<F> step, in VectorColumns<F> bend, bool isDown)
    {
        SurfaceBatch<R, F, I> s = _buffers.Surfaces;
        (F, F, F) d = (R.ToSingle(_buffers.DirectionX[packet]), R.ToSingle(_buffers.DirectionY[packet]), R.ToSingle(_buffers.DirectionZ[packet]));
        (F, F, F) n = (R.ToSingle(s.ShadingX[packet]), R.ToSingle(s.ShadingY[packet]), R.ToSingle(s.ShadingZ[packet]));
        (F, F, F) dd = (run.Collect<F, F>(turn.X), run.Collect<F, F>(turn.Y), run.Collect<F, F>(turn.Z));
        (F, F, F) dn = (bend.X[packet], bend.Y[packet], bend.Z[packet]);
        (F x, F y, F z) = SecondaryDifferentials.Reflect(d, n, dd, dn);
        DifferentialColumns<F> reflected = _reflected.Differentials, refracted = _refracted.Differentials;
        (isDown ? reflected.OriginDy : reflected.OriginDx).Store(packet, step.X[packet], step.Y[packet], step.Z[packet]);
        (isDown ? reflected.DirectionDy : reflected.DirectionDx).Store(packet, x, y, z);
        if (!material.Transparency.IsBlack)
        {
            F index = material.IndexOfRefraction.Read(_buffers.Texels, packet);
            F ratio = F.Select(R.MaskToSingle(_buffers.Inside[packet]), index, F.Of(1) / index);
            (x, y, z) = SecondaryDifferentials.Refract(ratio, d, n, dd, dn);
            (isDown ? refracted.OriginDy : refracted.OriginDx).Store(packet, step.X[packet], step.Y[packet], step.Z[packet]);
            (isDown ? refracted.DirectionDy : refracted.DirectionDx).Store(packet, x, y, z);
        }
    }
}
