namespace LabRaytracer;

/// <summary>What changes over a step on a shape that only knows one ray at a time: seen by a second ray, straight down onto the point a small part of the step away.</summary>
internal static class CustomSteps
{
    /// <summary>Step relative to the point's largest coordinate.</summary>
    private const double RelativeStep = 1.0 / (1 << 17);

    /// <summary>Height from which the second ray looks down, relative to the same.</summary>
    private const double RelativeHeight = 1.0 / 128;

    /// <summary>Local point, normal and own coordinates over a step.</summary>
    /// <param name="Local">Change of the local point.</param>
    /// <param name="Normal">Change of the shading normal, object space.</param>
    /// <param name="Surface">Change of the shape's own coordinates.</param>
    public readonly record struct Change(Vector3D Local, Vector3D Normal, TextureCoordinate Surface);

    /// <summary>The changes over a step.</summary>
    /// <param name="shape">The shape.</param>
    /// <param name="here">Where it was hit.</param>
    /// <param name="step">The step, object space, in the tangent plane.</param>
    /// <remarks>Where the second ray hits something else, the local point is taken to move with the step, and the normal to stay.</remarks>
    public static Change Along(Shape shape, in SurfacePoint here, Vector3D step)
    {
        double length = step.Length;
        if (!(length > 0) || !double.IsFinite(length))
        {
            return default;
        }

        double size = Math.Max(Math.Max(Math.Abs(here.Point.X), Math.Abs(here.Point.Y)), Math.Abs(here.Point.Z));
        size = size > 0 ? size : 1;
        double part = RelativeStep * size / length;
        Ray beside = new(here.Point + (step * part) + (here.Normal * (RelativeHeight * size)), -here.Normal);
        if (!shape.Intersect(beside, double.PositiveInfinity, out Hit hit))
        {
            return new Change(step, Vector3D.Zero, default);
        }

        SurfacePoint there = shape.SurfaceAt(beside, hit);
        bool isSameSurface = (there.Point - here.Point - (step * part)).Length <= 0.25 * part * length;
        return isSameSurface
            ? new Change(
                (there.Position.LocalPoint - here.Position.LocalPoint) / part,
                (there.ShadingNormal - here.ShadingNormal) / part,
                new TextureCoordinate((there.Position.Surface.U - here.Position.Surface.U) / part, (there.Position.Surface.V - here.Position.Surface.V) / part))
            : new Change(step, Vector3D.Zero, default);
    }

    /// <summary>The gradient in the plane of two local steps over which a number changes by given amounts; zero if the steps are parallel.</summary>
    public static Vector3D Gradient(Vector3D stepX, Vector3D stepY, double changeX, double changeY)
    {
        Vector3D normal = Vector3D.Cross(stepX, stepY);
        double square = normal.LengthSquared;
        return square > 0
            ? ((Vector3D.Cross(stepY, normal) * changeX) + (Vector3D.Cross(normal, stepX) * changeY)) / square
            : Vector3D.Zero;
    }
}
