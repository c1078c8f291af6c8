using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Tilts the shading normals of a group of hits by normal maps and heights.</summary>
/// <remarks>
/// <para>With two tangents t1, t2 of length 1 of the surface at each hit, the changes of u and v over them come from the gradients of the mapping, whatever the shape and
/// its transform. Heights h along the outward normal n give n' ~ (p_u + h_u n) x (p_v + h_v n) (Blinn 1978), which is n - grad h, with the gradient on the surface
/// grad h = h_u grad u + h_v grad v: so mirrored coordinates need no case of their own, and only the relief counts, not how it is parametrised.</para>
/// <para>A normal never faces away from the viewer: it is bent back until its cosine with the direction to the viewer is 1/100, or that of the surface itself where
/// that is less. A lamp lights a point only if it is above both the surface and the tilted normal's horizon.</para>
/// </remarks>
internal sealed unsafe class ReliefStage<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private const double LeastCosine = 0.01;

    private readonly CompiledScene<R, F, I> _scene;
    private readonly ShadingBuffers<R, F, I> _buffers;
    private readonly FootprintBuffers<R, F, I> _slopes;

    private ReliefStage(CompiledScene<R, F, I> scene, ShadingBuffers<R, F, I> buffers, LaneMemory memory, int capacity)
    {
        _scene = scene;
        _buffers = buffers;
        _slopes = new FootprintBuffers<R, F, I>(memory, capacity, buffers.Coordinates.Length);
    }

    /// <summary>What a worker needs for a scene; null if no material has a relief.</summary>
    public static ReliefStage<R, F, I>? Of(CompiledScene<R, F, I> scene, ShadingBuffers<R, F, I> buffers, LaneMemory memory, int capacity) =>
        scene.Keys.Any(key => key.Material.Relief is not null || key.Material.Inside?.Relief is not null)
            ? new ReliefStage<R, F, I>(scene, buffers, memory, capacity)
            : null;

    /// <summary>Tilts the normals of a group whose textures are looked up.</summary>
    /// <param name="material">The material, which has a relief.</param>
    /// <param name="group">The shapes that were hit.</param>
    /// <param name="rays">The rays that hit.</param>
    /// <param name="hits">Their hits.</param>
    /// <param name="order">Their numbers, padded to whole groups of lanes.</param>
    /// <param name="count">How many.</param>
    public void Run(CompiledMaterial material, ShapeGroup<R, F, I> group, RayBatch<R, F, I> rays, HitBatch<R, F, I> hits, int* order, int count)
    {
        CompiledRelief relief = material.Relief!;
        int packets = (count + R.Width - 1) / R.Width;
        for (int packet = 0; packet < packets; packet++)
        {
            Tangents(packet);
        }

        group.Differentiate(rays, hits, order, count, _scene.MemberOfObject, _buffers.Surfaces, _slopes.Steps, relief.Steps);
        if (relief.MapCoordinates >= 0)
        {
            FootprintStage.Map(material.Coordinates[relief.MapCoordinates], _buffers.Surfaces, _slopes, relief.MapCoordinates, count);
        }

        if (relief.BumpCoordinates >= 0 && relief.BumpCoordinates != relief.MapCoordinates)
        {
            FootprintStage.Map(material.Coordinates[relief.BumpCoordinates], _buffers.Surfaces, _slopes, relief.BumpCoordinates, count);
        }

        _buffers.Surfaces.SeparateNormals(packets);
        for (int packet = 0; packet < packets; packet++)
        {
            F tilted = F.Zero;
            if (relief.MapLookup >= 0)
            {
                ReadMap(relief, packet, out F along1, out F along2, out F up);
                tilted |= Tilt(packet, along1, along2, up);
            }

            if (relief.BumpLookup >= 0)
            {
                ReadSlopes(relief, packet, out F along1, out F along2);
                tilted |= Tilt(packet, along1, along2, F.Of(1));
            }

            FaceViewer(packet, R.MaskFromSingle(tilted));
        }
    }

    /// <summary>Two tangents of length 1 at a right angle, from the geometric normal (Duff et al. 2017).</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void Tangents(int packet)
    {
        SurfaceBatch<R, F, I> s = _buffers.Surfaces;
        F x = R.ToSingle(s.NormalX[packet]), y = R.ToSingle(s.NormalY[packet]), z = R.ToSingle(s.NormalZ[packet]);
        F sign = F.Select(F.Less(z, F.Zero), F.Of(-1), F.Of(1));
        F a = F.Of(-1) / (sign + z);
        F b = x * y * a;
        _slopes.Steps.WorldDx.Store(packet, F.Fma(sign * x * x, a, F.Of(1)), sign * b, -(sign * x));
        _slopes.Steps.WorldDy.Store(packet, b, F.Fma(y * y, a, sign), -y);
    }

    /// <summary>The normal of the map in the directions of the tangents and of the normal on the viewer's side.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void ReadMap(CompiledRelief relief, int packet, out F along1, out F along2, out F up)
    {
        NormalMap map = relief.Map!;
        ColorColumns<F> texels = _buffers.Texels[relief.MapLookup];
        F one = F.Of(1), two = F.Of(2);
        F x = F.Fma(two, texels.R[packet], -one), y = F.Fma(two, texels.G[packet], -one);
        up = map.RebuildZ ? F.Sqrt(F.Max(one - F.Fma(x, x, y * y), F.Zero)) : F.Fma(two, texels.B[packet], -one);
        x *= F.Of(map.Strength);
        y *= F.Of(map.FlipGreen ? -map.Strength : map.Strength);

        // The direction of growing v, and the one at a right angle to it on the side of growing u.
        FootprintColumns change = _slopes.Sets[relief.MapCoordinates];
        F u1 = ((F*)change.DuDx)[packet], v1 = ((F*)change.DvDx)[packet], u2 = ((F*)change.DuDy)[packet], v2 = ((F*)change.DvDy)[packet];
        F square = F.Fma(v1, v1, v2 * v2), turn = F.Fma(u1, v2, -(u2 * v1));
        F exists = F.Less(F.Of(1e-30), square) & ~F.Equal(turn, F.Zero);
        F scale = exists & (one / F.Sqrt(F.Select(exists, square, one)));
        scale = F.Select(Inside(packet), -scale, scale);
        F right = F.Select(F.Less(turn, F.Zero), -x, x);
        along1 = F.Fma(right, v2, y * v1) * scale;
        along2 = F.Fma(y, v2, -(right * v1)) * scale;
    }

    /// <summary>Minus the gradient of heights in the directions of the tangents; its sign is for the viewer's side.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void ReadSlopes(CompiledRelief relief, int packet, out F along1, out F along2)
    {
        ColorColumns<F> slopes = _buffers.Texels[relief.BumpLookup];
        F height = F.Of(relief.Height);
        height = F.Select(Inside(packet), height, -height);
        if (relief.BumpCoordinates >= 0)
        {
            FootprintColumns change = _slopes.Sets[relief.BumpCoordinates];
            along1 = height * F.Fma(slopes.R[packet], ((F*)change.DuDx)[packet], slopes.G[packet] * ((F*)change.DvDx)[packet]);
            along2 = height * F.Fma(slopes.R[packet], ((F*)change.DuDy)[packet], slopes.G[packet] * ((F*)change.DvDy)[packet]);
            return;
        }

        bool isWorld = relief.BumpSpace == SlopeSpace.World;
        VectorColumns<F> dx = isWorld ? _slopes.Steps.WorldDx : _slopes.Steps.LocalDx, dy = isWorld ? _slopes.Steps.WorldDy : _slopes.Steps.LocalDy;
        along1 = height * Lane.Dot(slopes.R[packet], slopes.G[packet], slopes.B[packet], dx.X[packet], dx.Y[packet], dx.Z[packet]);
        along2 = height * Lane.Dot(slopes.R[packet], slopes.G[packet], slopes.B[packet], dy.X[packet], dy.Y[packet], dy.Z[packet]);
    }

    private F Inside(int packet) => R.MaskToSingle(_buffers.Inside[packet]);

    /// <summary>The shading normal becomes up n + (t1 along1 + t2 along2), the latter without its part along n; not a bit changes where both are 0.</summary>
    /// <returns>Mask of the lanes that changed.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private F Tilt(int packet, F along1, F along2, F up)
    {
        F tilts = ~(F.Equal(along1, F.Zero) & F.Equal(along2, F.Zero));
        if (!F.Any(tilts))
        {
            return tilts;
        }

        SurfaceBatch<R, F, I> s = _buffers.Surfaces;
        VectorColumns<F> first = _slopes.Steps.WorldDx, second = _slopes.Steps.WorldDy;
        R x = R.FromSingle(F.Fma(first.X[packet], along1, second.X[packet] * along2));
        R y = R.FromSingle(F.Fma(first.Y[packet], along1, second.Y[packet] * along2));
        R z = R.FromSingle(F.Fma(first.Z[packet], along1, second.Z[packet] * along2));
        R nx = s.ShadingX[packet], ny = s.ShadingY[packet], nz = s.ShadingZ[packet];
        R part = R.FromSingle(up) - Lane.Dot(x, y, z, nx, ny, nz);
        Store(packet, R.MaskFromSingle(tilts), R.Fma(part, nx, x), R.Fma(part, ny, y), R.Fma(part, nz, z));
        return tilts;
    }

    /// <summary>Bends the normals of a mask back that face away from the viewer.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void FaceViewer(int packet, R mask)
    {
        SurfaceBatch<R, F, I> s = _buffers.Surfaces;
        R dx = _buffers.DirectionX[packet], dy = _buffers.DirectionY[packet], dz = _buffers.DirectionZ[packet];
        R nx = s.ShadingX[packet], ny = s.ShadingY[packet], nz = s.ShadingZ[packet];
        R least = R.Min(R.Of(LeastCosine), -Lane.Dot(s.NormalX[packet], s.NormalY[packet], s.NormalZ[packet], dx, dy, dz));
        R cosine = -Lane.Dot(nx, ny, nz, dx, dy, dz);
        R away = mask & R.Less(cosine, least);
        if (R.Any(away))
        {
            R back = cosine - least;
            Store(packet, away, R.Fma(back, dx, nx), R.Fma(back, dy, ny), R.Fma(back, dz, nz));
        }
    }

    /// <summary>Writes shading normals of a mask, made as long as 1; one of no length stays as it was.</summary>
    private void Store(int packet, R mask, R x, R y, R z)
    {
        SurfaceBatch<R, F, I> s = _buffers.Surfaces;
        R square = Lane.Dot(x, y, z, x, y, z);
        mask &= ~R.Equal(square, R.Zero);
        R toUnit = R.Of(1) / R.Sqrt(R.Select(mask, square, R.Of(1)));
        s.ShadingX[packet] = R.Select(mask, x * toUnit, s.ShadingX[packet]);
        s.ShadingY[packet] = R.Select(mask, y * toUnit, s.ShadingY[packet]);
        s.ShadingZ[packet] = R.Select(mask, z * toUnit, s.ShadingZ[packet]);
    }
}
