namespace LabRaytracer;

/// <summary>The sheet's own way from a hit to a texel, kept as printed: for comparison and for graded results.</summary>
/// <remarks>The renderer uses <see cref="SphericalMapping"/> and a sampler instead. Thread safe.</remarks>
public static class TexelCoordinates
{
    private const double TwoPi = 6.2831853071795864769;
    private const double InverseTwoPi = 0.1591549430918953358;
    private const double InversePi = 0.3183098861837906715;

    /// <summary>Program 2 of the sheet (<c>SphericalMap::get_texel_coordinates</c>), operation by operation, in its mix of float and double.</summary>
    /// <param name="localHitPoint">The hit on the unit sphere, object space.</param>
    /// <param name="xres">Width of the picture, texels; at least 1.</param>
    /// <param name="yres">Height of the picture, texels; at least 1.</param>
    /// <param name="row">Row of the texel, upward: 0 is the bottom row. [0, yres - 1] unless the point is off the sphere.</param>
    /// <param name="column">Column of the texel, [0, xres - 1].</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="xres"/> or <paramref name="yres"/> is below 1.</exception>
    /// <remarks>
    /// <para>Lab sheet IV, section 1.1.3. Its faults are part of it: the last column and row are reached only at u = 1 and v = 1 exactly,
    /// u rounds to 1 just before the seam, and |y| a hair above 1 gives NaN, which the cast turns into row 0, the opposite pole's at y &gt; 1.</para>
    /// <para>Calls <see cref="Math.Acos"/> and <see cref="Math.Atan2"/>, whose last bits depend on the machine.</para>
    /// </remarks>
    public static void GetTexelCoordinates(in Point3D localHitPoint, int xres, int yres, out int row, out int column)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(xres, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(yres, 1);

        // First the angles theta and phi,
        float theta = (float)Math.Acos(localHitPoint.Y);
        float phi = (float)Math.Atan2(localHitPoint.X, localHitPoint.Z);
        if (phi < 0.0)
        {
            phi = (float)(phi + TwoPi);
        }

        // then theta and phi to (u, v) in [0, 1] x [0, 1],
        float u = (float)(phi * InverseTwoPi);
        float v = (float)(1.0 - (theta * InversePi));

        // finally u and v to the texel.
        column = (int)((xres - 1) * u);
        row = (int)((yres - 1) * v);
    }
}
