using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Light of a point lamp on matte hits that nothing can keep from it: straight from surface points to radiance, no shadow rays.</summary>
/// <remarks>The bits of <see cref="PointShadows"/> and <see cref="MatteLight"/> where no ray is blocked.</remarks>
[SkipLocalsInit]
internal static unsafe class OpenLight
{
    /// <summary>Adds the lamp's light to some groups of lanes.</summary>
    /// <param name="lamp">The lamp.</param>
    /// <param name="material">A matte material.</param>
    /// <param name="buffers">The hits; receives the light.</param>
    /// <param name="first">First group of lanes.</param>
    /// <param name="end">Group of lanes after the last one.</param>
    /// <param name="count">Number of all hits: lanes after them only fill their group.</param>
    /// <returns>Number of hits that the lamp lights: so many shadow rays would have been on.</returns>
    public static int Add<R, F, I>(PointLight lamp, CompiledMaterial material, ShadingBuffers<R, F, I> buffers, int first, int end, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        SurfaceBatch<R, F, I> s = buffers.Surfaces;
        OpenColumns<R, F> columns = new(
            new(s.PointX, s.PointY, s.PointZ),
            new(s.NormalX, s.NormalY, s.NormalZ),
            new(s.ShadingX, s.ShadingY, s.ShadingZ),
            material.Diffuse.Lookup < 0 ? default : buffers.Texels[material.Diffuse.Lookup],
            buffers.Radiance);
        PointLight.Formula formula = lamp.Own;

        // Eight doubles are two registers of which there are few: half as many lanes at a time stay in them.
        return typeof(R) == typeof(Double8)
            ? Each<Double4, Float4, Int4>(
                formula, material.Diffuse.Value, Unsafe.As<OpenColumns<R, F>, OpenColumns<Double4, Float4>>(ref columns), 2 * first, 2 * end, count)
            : Each<R, F, I>(formula, material.Diffuse.Value, columns, first, end, count);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int Each<R, F, I>(in PointLight.Formula formula, Intensity coefficient, in OpenColumns<R, F> columns, int first, int end, int count)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        OpenColumns<R, F> at = columns;
        PointLight.Formula lamp = formula;
        F red = F.Of(lamp.Intensity.R), green = F.Of(lamp.Intensity.G), blue = F.Of(lamp.Intensity.B);
        F dr = F.Of(coefficient.R), dg = F.Of(coefficient.G), db = F.Of(coefficient.B);
        int lit = 0;
        for (int packet = first; packet < end; packet++)
        {
            R x = R.Of(lamp.Position.X) - at.Point.X[packet], y = R.Of(lamp.Position.Y) - at.Point.Y[packet], z = R.Of(lamp.Position.Z) - at.Point.Z[packet];
            R nx = at.Normal.X[packet], ny = at.Normal.Y[packet], nz = at.Normal.Z[packet];
            R share = lamp.Share(x, y, z, out R distance), mask = R.Less(R.Zero, distance) & R.Less(R.Zero, Lane.Dot(nx, ny, nz, x, y, z));
            if (at.Shading.X != at.Normal.X)
            {
                (nx, ny, nz) = (at.Shading.X[packet], at.Shading.Y[packet], at.Shading.Z[packet]);
                mask &= R.Less(R.Zero, Lane.Dot(nx, ny, nz, x, y, z));
            }

            F visible = R.MaskToSingle(mask), cosine = PointShadows.Cosine<R, F, I>(nx, ny, nz, x, y, z, distance) & visible, part = R.ToSingle(share) & visible;
            F r = dr, g = dg, b = db;
            if (at.Texels.R != null)
            {
                r *= at.Texels.R[packet];
                g *= at.Texels.G[packet];
                b *= at.Texels.B[packet];
            }

            at.Radiance.R[packet] = F.Fma(r * cosine, red * part, at.Radiance.R[packet]);
            at.Radiance.G[packet] = F.Fma(g * cosine, green * part, at.Radiance.G[packet]);
            at.Radiance.B[packet] = F.Fma(b * cosine, blue * part, at.Radiance.B[packet]);
            lit += BitOperations.PopCount(R.Bits(mask) & PointShadows.Held(count - (packet * R.Width)));
        }

        return lit;
    }

    /// <summary>What is read and written.</summary>
    private readonly struct OpenColumns<R, F>(VectorColumns<R> point, VectorColumns<R> normal, VectorColumns<R> shading, ColorColumns<F> texels, ColorColumns<F> radiance)
        where R : unmanaged, IReal<R>
        where F : unmanaged, IReal<F>
    {
        public readonly VectorColumns<R> Point = point, Normal = normal, Shading = shading;
        public readonly ColorColumns<F> Texels = texels, Radiance = radiance;
    }
}
