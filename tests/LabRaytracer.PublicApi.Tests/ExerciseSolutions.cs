namespace LabRaytracer.PublicApi.Tests;

/// <summary>Solutions of samples/Exercises.</summary>
internal static class ExerciseSolutions
{
    /// <summary>Exercise 1.</summary>
    internal sealed class Rectangular : IMapping
    {
        public TextureCoordinate Map(in SurfacePosition position) => new((position.LocalPoint.Z + 1) / 2, (position.LocalPoint.X + 1) / 2);
    }

    /// <summary>Exercise 3; exercise 2 is <see cref="MyCylindricalMapping"/>.</summary>
    internal sealed class Spherical : IMapping
    {
        public TextureCoordinate Map(in SurfacePosition position)
        {
            Point3D p = position.LocalPoint;
            double phi = Math.Atan2(p.X, p.Z), theta = Math.Atan2(Math.Sqrt((p.X * p.X) + (p.Z * p.Z)), p.Y);
            return new TextureCoordinate((phi < 0 ? phi + (2 * Math.PI) : phi) / (2 * Math.PI), 1 - (theta / Math.PI));
        }
    }

    /// <summary>Exercise 4.</summary>
    internal static int Repeat(int texel, int size)
    {
        int rest = texel % size;
        return rest < 0 ? rest + size : rest;
    }

    /// <summary>Exercise 5.</summary>
    internal static Intensity Bilinear(Texture texture, double u, double v)
    {
        double x = (texture.Width - 1) * u, y = (texture.Height - 1) * v;
        int left = (int)x, bottom = (int)y;
        int right = Math.Min(left + 1, texture.Width - 1), top = Math.Min(bottom + 1, texture.Height - 1);
        Intensity below = Intensity.Lerp(texture.ColorMap[left, bottom], texture.ColorMap[right, bottom], (float)(x - left));
        Intensity above = Intensity.Lerp(texture.ColorMap[left, top], texture.ColorMap[right, top], (float)(x - left));
        return Intensity.Lerp(below, above, (float)(y - bottom));
    }
}
