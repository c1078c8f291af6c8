using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>The geometry of hits, as many as a lane type is wide: what a kernel computes of <see cref="SurfacePoint"/>.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
internal struct SurfaceLanes<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Hit point, in the space of the ray.</summary>
    public R PointX, PointY, PointZ;

    /// <summary>Outward geometric normal, length 1.</summary>
    public R NormalX, NormalY, NormalZ;

    /// <summary>Normal for shading, length 1.</summary>
    public R ShadingX, ShadingY, ShadingZ;

    /// <summary>The point in the shape's unit form.</summary>
    public R LocalX, LocalY, LocalZ;

    /// <summary>The outward normal in the shape's unit form, length 1.</summary>
    public R LocalNormalX, LocalNormalY, LocalNormalZ;

    /// <summary>The shape's own texture coordinates.</summary>
    public R SurfaceU, SurfaceV;

    /// <summary>Bound of the error of each coordinate of the point.</summary>
    public R Slack;
}

/// <summary>Between one surface point and lanes.</summary>
internal static class SurfaceLanes
{
    /// <summary>Lane by lane, one or the other.</summary>
    public static SurfaceLanes<R> Select<R>(R mask, in SurfaceLanes<R> yes, in SurfaceLanes<R> no)
        where R : unmanaged, IReal<R>
    {
        SurfaceLanes<R> selected = no;
        Span<R> result = MemoryMarshal.Cast<SurfaceLanes<R>, R>(new Span<SurfaceLanes<R>>(ref selected));
        ReadOnlySpan<R> added = MemoryMarshal.Cast<SurfaceLanes<R>, R>(new ReadOnlySpan<SurfaceLanes<R>>(in yes));
        for (int k = 0; k < result.Length; k++)
        {
            result[k] = R.Select(mask, added[k], result[k]);
        }

        return selected;
    }

    /// <summary>A surface point as one lane.</summary>
    public static SurfaceLanes<Double1> Of(in SurfacePoint s) => new()
    {
        PointX = new(s.Point.X), PointY = new(s.Point.Y), PointZ = new(s.Point.Z),
        NormalX = new(s.Normal.X), NormalY = new(s.Normal.Y), NormalZ = new(s.Normal.Z),
        ShadingX = new(s.ShadingNormal.X), ShadingY = new(s.ShadingNormal.Y), ShadingZ = new(s.ShadingNormal.Z),
        LocalX = new(s.Position.LocalPoint.X), LocalY = new(s.Position.LocalPoint.Y), LocalZ = new(s.Position.LocalPoint.Z),
        LocalNormalX = new(s.Position.LocalNormal.X), LocalNormalY = new(s.Position.LocalNormal.Y), LocalNormalZ = new(s.Position.LocalNormal.Z),
        SurfaceU = new(s.Position.Surface.U), SurfaceV = new(s.Position.Surface.V),
        Slack = new(s.Slack),
    };
}
