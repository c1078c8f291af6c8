namespace LabRaytracer;

/// <summary>Reflected and refracted rays of a group of hits (Whitted 1980).</summary>
internal sealed unsafe class SecondaryStage<R, F, I>(ShadingBuffers<R, F, I> buffers, SecondaryRays secondary, WorkerCounters counters)
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>
    /// A ray of less weight than this in every channel is not followed: light of up to 4 times display white that it brings
    /// then changes an 8-bit linear code value by less than 1/4.
    /// </summary>
    public const float LeastWeight = 1f / 4096;

    /// <summary>Makes the secondary rays of a group.</summary>
    /// <param name="material">The material, which mirrors or transmits.</param>
    /// <param name="order">Numbers of the rays that hit.</param>
    /// <param name="count">How many.</param>
    /// <param name="weights">Weight of each ray of the batch.</param>
    /// <param name="pixels">Pixel of each ray of the batch.</param>
    public void Run(CompiledMaterial material, int* order, int count, Intensity[] weights, int[] pixels)
    {
        for (int i = 0; i < count; i++)
        {
            int packet = i / R.Width, lane = i % R.Width, ray = order[i];
            material.Reflection.Read(buffers.Texels, packet, out F red, out F green, out F blue);
            Intensity reflection = At(red, green, blue, lane);
            if (!material.Transparency.IsBlack)
            {
                material.Transparency.Read(buffers.Texels, packet, out red, out green, out blue);
                double index = F.Get(material.IndexOfRefraction.Read(buffers.Texels, packet), lane);
                reflection += Refract(material.Material.Fresnel, index, At(red, green, blue, lane), i, ray, weights[ray], pixels[ray]);
            }

            Reflect(reflection * weights[ray], i, ray, pixels[ray]);
        }
    }

    /// <summary>Keeps the refracted ray; returns the share that is reflected instead.</summary>
    private Intensity Refract(FresnelModel model, double index, Intensity transparency, int i, int ray, Intensity weight, int pixel)
    {
        double ratio = R.Take(buffers.Inside, i) == 0 ? 1 / index : index;
        Vector3D direction = Direction(i), normal = Shading(i);
        double cosNear = Math.Min(1, Math.Max(0, -Vector3D.Dot(direction, normal)));
        double sinSquared = ratio * ratio * (1 - (cosNear * cosNear));
        if (!(sinSquared < 1))
        {
            // Total reflection: nothing leaves through the surface.
            return transparency;
        }

        double cosFar = Math.Sqrt(1 - sinSquared);
        double reflected = model switch
        {
            FresnelModel.Dielectric => Fresnel.Dielectric(ratio, cosNear, cosFar),
            FresnelModel.Schlick => Fresnel.Schlick(ratio, cosNear, cosFar),
            _ => 0,
        };
        Intensity share = transparency * (float)(1 - reflected) * weight;
        if (IsFollowed(share))
        {
            Vector3D refracted = (direction * ratio) + (normal * ((ratio * cosNear) - cosFar));
            secondary.Refract(ray, new SecondaryRay(new Ray(Outside(i, -1), Unit(refracted)), share, pixel));
        }

        return transparency * (float)reflected;
    }

    private void Reflect(Intensity share, int i, int ray, int pixel)
    {
        if (!IsFollowed(share))
        {
            return;
        }

        Vector3D direction = Direction(i), normal = Shading(i), geometric = Normal(i);
        Vector3D mirrored = direction - (normal * (2 * Vector3D.Dot(direction, normal)));

        // An interpolated normal can mirror into the surface: bend the ray back to the horizon's near side.
        double below = Vector3D.Dot(mirrored, geometric);
        if (below <= 0)
        {
            mirrored += geometric * (1e-4 - below);
        }

        secondary.Reflect(ray, new SecondaryRay(new Ray(Outside(i, 1), Unit(mirrored)), share, pixel));
    }

    private bool IsFollowed(Intensity share)
    {
        if (share.Max >= LeastWeight)
        {
            counters.SecondaryRays++;
            return true;
        }

        if (share.Max > 0)
        {
            counters.SecondaryRaysSkipped++;
        }

        return false;
    }

    /// <summary>The hit point moved out of its error bound, to the viewer's side (1) or the other one (-1).</summary>
    private Point3D Outside(int i, int side)
    {
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        Point3D point = new(R.Take(s.PointX, i), R.Take(s.PointY, i), R.Take(s.PointZ, i));
        return point + (Normal(i) * (side * R.Take(s.Slack, i)));
    }

    private Vector3D Direction(int i) => new(R.Take(buffers.DirectionX, i), R.Take(buffers.DirectionY, i), R.Take(buffers.DirectionZ, i));

    private Vector3D Normal(int i)
    {
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        return new Vector3D(R.Take(s.NormalX, i), R.Take(s.NormalY, i), R.Take(s.NormalZ, i));
    }

    private Vector3D Shading(int i)
    {
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        return new Vector3D(R.Take(s.ShadingX, i), R.Take(s.ShadingY, i), R.Take(s.ShadingZ, i));
    }

    private static Vector3D Unit(Vector3D v) => v / Math.Sqrt(v.LengthSquared);

    private static Intensity At(F red, F green, F blue, int lane) => new((float)F.Get(red, lane), (float)F.Get(green, lane), (float)F.Get(blue, lane));
}
