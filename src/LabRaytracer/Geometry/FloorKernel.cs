using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The formulas of <see cref="PlaneKernel"/> where the normal is +Y: products with 0 and 1 and what they leave are gone, the numbers are the same.</summary>
internal static class FloorKernel
{
    /// <summary>Hits with t above 0.</summary>
    /// <param name="height">y of the plane.</param>
    /// <param name="originY">y of the origins.</param>
    /// <param name="directionY">y of the directions.</param>
    /// <param name="t">Ray parameters where the mask is true.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static R Intersect<R>(R height, R originY, R directionY, out R t)
        where R : unmanaged, IReal<R>
    {
        R way = Compensated.Difference(height, originY, out R rest);
        R inverse = R.Of(1) / directionY;
        R quotient = way * inverse;
        t = R.Fma(R.Fma(-quotient, directionY, way) + rest, inverse, quotient);
        return R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity));
    }

    /// <summary>The point relative to the plane's own one; its y is 0.</summary>
    /// <param name="x">x of the plane's point.</param>
    /// <param name="y">y of the plane's point.</param>
    /// <param name="z">z of the plane's point.</param>
    /// <param name="originX">Origins.</param>
    /// <param name="originY">Origins.</param>
    /// <param name="originZ">Origins.</param>
    /// <param name="directionX">Directions.</param>
    /// <param name="directionY">Directions.</param>
    /// <param name="directionZ">Directions.</param>
    /// <param name="t">Ray parameters of the hits.</param>
    /// <param name="qx">x of the hits.</param>
    /// <param name="qz">z of the hits.</param>
    /// <remarks>Numbers, not a structure of rays: the compiler keeps structures of more than four fields in memory.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Reach<R>(
        R x, R y, R z, R originX, R originY, R originZ, R directionX, R directionY, R directionZ, R t, out R qx, out R qz)
        where R : unmanaged, IReal<R>
    {
        R qy = R.Fma(t, directionY, Compensated.Difference(originY, y, out R restY)) + restY;
        R again = -qy / directionY;
        qx = R.Fma(t, directionX, Compensated.Difference(originX, x, out R restX)) + restX;
        qz = R.Fma(t, directionZ, Compensated.Difference(originZ, z, out R restZ)) + restZ;
        qx = R.Fma(again, directionX, qx);
        qz = R.Fma(again, directionZ, qz);
    }
}
