namespace LabRaytracer;

/// <summary>Gradients of mappings that do not say their own: by differences.</summary>
internal static class MappingDifferences
{
    /// <summary>Step relative to the point's largest coordinate: the cube root of the double's precision, where the errors of rounding and of curvature are alike.</summary>
    private const double RelativeStep = 1.0 / (1 << 17);

    /// <summary>Differences around a point to both sides, along each axis.</summary>
    /// <remarks>
    /// Whole turns between both ends of a difference are a seam and do not count. Where both sides still disagree (an edge between faces), the flatter one is taken.
    /// The surface's own coordinates follow their own gradient.
    /// </remarks>
    public static MappingGradient Gradient(IMapping mapping, in SurfacePosition position)
    {
        Point3D place = mapping.Frame == TextureFrame.World ? position.WorldPoint : position.LocalPoint;
        double size = Math.Max(Math.Max(Math.Abs(place.X), Math.Abs(place.Y)), Math.Abs(place.Z));
        double step = RelativeStep * (size > 0 ? size : 1);
        (double ux, double vx) = Along(mapping, position, new Vector3D(step, 0, 0), step);
        (double uy, double vy) = Along(mapping, position, new Vector3D(0, step, 0), step);
        (double uz, double vz) = Along(mapping, position, new Vector3D(0, 0, step), step);
        return new MappingGradient(new Vector3D(ux, uy, uz), new Vector3D(vx, vy, vz));
    }

    private static (double U, double V) Along(IMapping mapping, in SurfacePosition position, Vector3D offset, double step)
    {
        TextureCoordinate before = mapping.Map(Moved(mapping.Frame, position, -offset));
        TextureCoordinate here = mapping.Map(position);
        TextureCoordinate after = mapping.Map(Moved(mapping.Frame, position, offset));
        return (Slope(before.U, here.U, after.U) / step, Slope(before.V, here.V, after.V) / step);
    }

    private static SurfacePosition Moved(TextureFrame frame, in SurfacePosition position, Vector3D offset)
    {
        if (frame == TextureFrame.World)
        {
            return position with { WorldPoint = position.WorldPoint + offset };
        }

        TextureFootprint own = position.SurfaceGradient.Over(offset, default);
        return position with
        {
            LocalPoint = position.LocalPoint + offset,
            Surface = new TextureCoordinate(position.Surface.U + own.DuDx, position.Surface.V + own.DvDx),
        };
    }

    private static double Slope(double before, double here, double after)
    {
        double back = WithoutTurns(here - before), ahead = WithoutTurns(after - here);
        bool agree = Math.Abs(ahead - back) <= 0.5 * Math.Max(Math.Abs(ahead), Math.Abs(back));
        double slope = agree ? (ahead + back) / 2 : Math.Abs(ahead) < Math.Abs(back) ? ahead : back;
        return double.IsFinite(slope) ? slope : 0;
    }

    private static double WithoutTurns(double difference) => difference - Math.Round(difference);
}
