using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The usual case of <see cref="LightStage{R, F, I}"/>: plain coefficients, no highlight, no emission that varies. The same bits in a third of the time.</summary>
[SkipLocalsInit]
internal static unsafe class MatteLight
{
    /// <summary>Tells whether <see cref="Begin"/> is enough for a material.</summary>
    public static bool IsEvenlyPlain(CompiledMaterial material) => material.Emission.Lookup < 0 && material.Ambient.IsPlain && !material.IsOccluded
        && (material.Emission.IsBlack || !material.Material.EmitsFromFrontOnly) && material.LightMap.IsBlack;

    /// <summary>Tells whether <see cref="Add"/> is enough for a material.</summary>
    public static bool IsMatte(CompiledMaterial material) =>
        material.Diffuse.IsPlain && material.Specular.IsBlack && material.Material.Shader is PhongShader or LambertShader or BlinnPhongShader;

    /// <summary>Emission and ambient light.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Begin<R, F, I>(CompiledMaterial material, Intensity light, ShadingBuffers<R, F, I> buffers, int packets)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        ColorColumns<F> radiance = buffers.Radiance;
        PlainSlot<F> ambient = new(material.Ambient, buffers.Texels);
        F emittedR = F.Of(material.Emission.Value.R), emittedG = F.Of(material.Emission.Value.G), emittedB = F.Of(material.Emission.Value.B);
        F lightR = F.Of(light.R), lightG = F.Of(light.G), lightB = F.Of(light.B);
        for (int packet = 0; packet < packets; packet++)
        {
            ambient.Read(packet, out F red, out F green, out F blue);
            radiance.R[packet] = F.Fma(red, lightR, emittedR);
            radiance.G[packet] = F.Fma(green, lightG, emittedG);
            radiance.B[packet] = F.Fma(blue, lightB, emittedB);
        }
    }

    /// <summary>Light of the current lamp where nothing blocks it.</summary>
    /// <param name="material">A matte material.</param>
    /// <param name="buffers">The hits; receives the light.</param>
    /// <param name="first">First group of lanes.</param>
    /// <param name="end">Group of lanes after the last one.</param>
    /// <param name="isKnown">Whether the cosines are known already.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Add<R, F, I>(CompiledMaterial material, ShadingBuffers<R, F, I> buffers, int first, int end, bool isKnown)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        LightColumns<R, F> light = buffers.Light;
        ColorColumns<F> radiance = buffers.Radiance;
        R* limits = buffers.ShadowRays.Limit;
        PlainSlot<F> diffuse = new(material.Diffuse, buffers.Texels);
        for (int packet = first; packet < end; packet++)
        {
            F visible = R.MaskToSingle(R.Less(R.Zero, limits[packet]));
            if (!F.Any(visible))
            {
                continue;
            }

            F cosine = isKnown ? light.Cosine[packet] : Cosine(s, light, packet);
            diffuse.Read(packet, out F red, out F green, out F blue);
            radiance.R[packet] = F.Fma(red * cosine, light.Intensity.R[packet] & visible, radiance.R[packet]);
            radiance.G[packet] = F.Fma(green * cosine, light.Intensity.G[packet] & visible, radiance.G[packet]);
            radiance.B[packet] = F.Fma(blue * cosine, light.Intensity.B[packet] & visible, radiance.B[packet]);
        }
    }

    /// <summary>Cosines of the angles between normals and directions of light, not below 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Cosine<R, F, I>(SurfaceBatch<R, F, I> s, in LightColumns<R, F> light, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => F.Max(
            Lane.Dot(
                R.ToSingle(s.ShadingX[packet]), R.ToSingle(s.ShadingY[packet]), R.ToSingle(s.ShadingZ[packet]),
                R.ToSingle(light.DirectionX[packet]), R.ToSingle(light.DirectionY[packet]), R.ToSingle(light.DirectionZ[packet])),
            F.Zero);
}
