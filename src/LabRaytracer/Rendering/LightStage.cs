using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Lamps and shadows of a group of hits.</summary>
[SkipLocalsInit]
internal sealed unsafe partial class LightStage<R, F, I>(
    CompiledScene<R, F, I> scene,
    ShadingBuffers<R, F, I> buffers,
    LampSampler<R, F, I> lamps,
    WorkerCounters counters,
    RayTally? tally,
    AlphaShadows<R, F, I>? alpha)
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    private readonly bool _hasPoints = scene.Lights.Any(light => light is PointLight);

    /// <summary>Starts the radiance with emission and ambient light, then adds every lamp's share.</summary>
    /// <param name="material">The material of the hits.</param>
    /// <param name="order">Numbers of the rays that hit.</param>
    /// <param name="count">How many.</param>
    public void Run(CompiledMaterial material, int* order, int count)
    {
        int packets = (count + R.Width - 1) / R.Width;
        Begin(material, packets);
        if (!material.IsLit)
        {
            counters.UnlitHits += (long)count * scene.Lights.Length;
        }

        if (material.IsLit || !scene.IsSkipping)
        {
            if (_hasPoints)
            {
                _hits.Find(buffers.Surfaces, buffers.ShadowRays.Source, packets);
            }

            for (int lamp = 0; lamp < scene.Lights.Length; lamp++)
            {
                AddLamp(lamp, material, order, count, packets);
            }
        }

        counters.Charge(RenderStage.Light);
    }

    private void Begin(CompiledMaterial material, int packets)
    {
        ColorColumns<F> radiance = buffers.Radiance;
        bool hasEvenSky = scene.EvenSky != Intensity.Black && !material.Diffuse.IsBlack;
        bool hasAmbient = scene.Ambient != Intensity.Black && !material.Ambient.IsBlack;
        if (hasAmbient && !hasEvenSky && MatteLight.IsEvenlyPlain(material))
        {
            MatteLight.Begin(material, scene.Ambient, buffers, packets);
            return;
        }

        bool emitsFromFrontOnly = material.Material.EmitsFromFrontOnly;
        CompiledSlot emission = material.Emission, ambient = material.Ambient, diffuse = material.Diffuse;
        for (int packet = 0; packet < packets; packet++)
        {
            emission.Read(buffers.Texels, packet, out F red, out F green, out F blue);
            if (emitsFromFrontOnly)
            {
                F front = ~R.MaskToSingle(buffers.Inside[packet]);
                red &= front;
                green &= front;
                blue &= front;
            }

            if (hasAmbient)
            {
                AddEven(material, ambient, scene.Ambient, packet, ref red, ref green, ref blue);
            }

            if (hasEvenSky)
            {
                AddEven(material, diffuse, scene.EvenSky, packet, ref red, ref green, ref blue);
            }

            radiance.R[packet] = red;
            radiance.G[packet] = green;
            radiance.B[packet] = blue;
        }

        if (!material.LightMap.IsBlack)
        {
            AddLightMap(material, packets);
        }
    }

    /// <summary>Adds light that is the same from everywhere.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void AddEven(CompiledMaterial material, in CompiledSlot slot, Intensity light, int packet, ref F red, ref F green, ref F blue)
    {
        slot.Read(buffers.Texels, packet, out F kr, out F kg, out F kb);
        if (material.IsOccluded)
        {
            F open = material.Occlusion.Read(buffers.Texels, packet);
            kr *= open;
            kg *= open;
            kb *= open;
        }

        red = F.Fma(kr, F.Of(light.R), red);
        green = F.Fma(kg, F.Of(light.G), green);
        blue = F.Fma(kb, F.Of(light.B), blue);
    }

    /// <summary>Adds the light that was computed beforehand.</summary>
    private void AddLightMap(CompiledMaterial material, int packets)
    {
        ColorColumns<F> radiance = buffers.Radiance;
        for (int packet = 0; packet < packets; packet++)
        {
            material.Diffuse.Read(buffers.Texels, packet, out F dr, out F dg, out F db);
            material.LightMap.Read(buffers.Texels, packet, out F red, out F green, out F blue);
            radiance.R[packet] = F.Fma(dr, red, radiance.R[packet]);
            radiance.G[packet] = F.Fma(dg, green, radiance.G[packet]);
            radiance.B[packet] = F.Fma(db, blue, radiance.B[packet]);
        }
    }

    private void AddLamp(int lamp, CompiledMaterial material, int* order, int count, int packets)
    {
        if (scene.Lights[lamp] is PointLight point)
        {
            AddPoint(point, material, order, count, packets);
            return;
        }

        int samples = lamps.Begin(lamp, order, packets);
        counters.LampSamples += samples > 1 ? (long)count * samples : 0;
        for (int sample = 0; sample < samples; sample++)
        {
            Aim(lamp, sample, count, packets);
            tally?.Add(buffers.ShadowRays, order, count);
            buffers.ShadowRays.Renew();
            Block(scene.Lights[lamp], 0, packets);
            if (!scene.IsSkipping)
            {
                Forget(packets);
            }

            Reflect(material, packets, count, knowsCosines: false);
        }
    }

    /// <summary>What the hits reflect of the light that arrives.</summary>
    private void Reflect(CompiledMaterial material, int packets, int count, bool knowsCosines)
    {
        if (!material.IsLit)
        {
            return;
        }

        if (MatteLight.IsMatte(material))
        {
            MatteLight.Add(material, buffers, 0, packets, knowsCosines);
            return;
        }

        IShader shader = material.Material.Shader;
        if (shader is not IWideShader wide)
        {
            AddEach(material, shader, count);
            return;
        }

        ColorColumns<F> radiance = buffers.Radiance;
        LightColumns<R, F> light = buffers.Light;
        bool isPhong = shader is PhongShader;
        for (int packet = 0; packet < packets; packet++)
        {
            F visible = R.MaskToSingle(R.Less(R.Zero, buffers.ShadowRays.Limit[packet]));
            if (!F.Any(visible))
            {
                continue;
            }

            Describe(material, packet, out ShaderLanes<F> point);
            F red, green, blue;
            if (isPhong)
            {
                // The usual model, called directly: a virtual generic method is looked up at each call.
                PhongShader.Formula(point, out red, out green, out blue);
            }
            else
            {
                wide.Reflect(point, out red, out green, out blue);
            }

            radiance.R[packet] = F.Fma(red, light.Intensity.R[packet] & visible, radiance.R[packet]);
            radiance.G[packet] = F.Fma(green, light.Intensity.G[packet] & visible, radiance.G[packet]);
            radiance.B[packet] = F.Fma(blue, light.Intensity.B[packet] & visible, radiance.B[packet]);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Describe(CompiledMaterial material, int packet, out ShaderLanes<F> point)
    {
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        LightColumns<R, F> light = buffers.Light;
        Unsafe.SkipInit(out point);
        material.Diffuse.Read(buffers.Texels, packet, out point.DiffuseR, out point.DiffuseG, out point.DiffuseB);
        point.NormalX = R.ToSingle(s.ShadingX[packet]);
        point.NormalY = R.ToSingle(s.ShadingY[packet]);
        point.NormalZ = R.ToSingle(s.ShadingZ[packet]);
        point.LightX = R.ToSingle(light.DirectionX[packet]);
        point.LightY = R.ToSingle(light.DirectionY[packet]);
        point.LightZ = R.ToSingle(light.DirectionZ[packet]);
        if (!material.Specular.IsBlack)
        {
            material.Specular.Read(buffers.Texels, packet, out point.SpecularR, out point.SpecularG, out point.SpecularB);
            point.Shininess = material.Shininess.Read(buffers.Texels, packet);
            point.ViewX = R.ToSingle(-buffers.DirectionX[packet]);
            point.ViewY = R.ToSingle(-buffers.DirectionY[packet]);
            point.ViewZ = R.ToSingle(-buffers.DirectionZ[packet]);
        }
        else
        {
            point.SpecularR = point.SpecularG = point.SpecularB = point.Shininess = F.Zero;
            point.ViewX = point.ViewY = point.ViewZ = F.Zero;
        }
    }

    /// <summary>A lighting model that only knows one point at a time.</summary>
    private void AddEach(CompiledMaterial material, IShader shader, int count)
    {
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        for (int i = 0; i < count; i++)
        {
            if (!(R.Take(buffers.ShadowRays.Limit, i) > 0))
            {
                continue;
            }

            int packet = i / R.Width, lane = i % R.Width;
            material.Diffuse.Read(buffers.Texels, packet, out F dr, out F dg, out F db);
            material.Specular.Read(buffers.Texels, packet, out F sr, out F sg, out F sb);
            SurfaceValues values = new(
                At(dr, dg, db, lane), At(sr, sg, sb, lane), (float)F.Get(material.Shininess.Read(buffers.Texels, packet), lane));
            Intensity share = shader.Reflect(
                values,
                new Vector3D(R.Take(s.ShadingX, i), R.Take(s.ShadingY, i), R.Take(s.ShadingZ, i)),
                new Vector3D(R.Take(buffers.Light.DirectionX, i), R.Take(buffers.Light.DirectionY, i), R.Take(buffers.Light.DirectionZ, i)),
                new Vector3D(-R.Take(buffers.DirectionX, i), -R.Take(buffers.DirectionY, i), -R.Take(buffers.DirectionZ, i)));

            // Rounded once, as in the wide path: the same bits.
            Intensity light = buffers.Light.Intensity.Take(i), sum = buffers.Radiance.Take(i);
            buffers.Radiance.Put(i, new Intensity(
                MathF.FusedMultiplyAdd(share.R, light.R, sum.R),
                MathF.FusedMultiplyAdd(share.G, light.G, sum.G),
                MathF.FusedMultiplyAdd(share.B, light.B, sum.B)));
        }
    }

    private static Intensity At(F red, F green, F blue, int lane) => new((float)F.Get(red, lane), (float)F.Get(green, lane), (float)F.Get(blue, lane));
}
