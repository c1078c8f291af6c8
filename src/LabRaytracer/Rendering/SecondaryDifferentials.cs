namespace LabRaytracer;

/// <summary>How reflected and refracted rays change from one sample to the next (Igehy 1999).</summary>
internal static unsafe class SecondaryDifferentials
{
    /// <summary>Below this cosine the refracted ray leaves along the surface and its differential has no end.</summary>
    private const double LeastCosine = 1e-3;

    /// <summary>Mirrored: d - 2 (d . n) n, differentiated.</summary>
    /// <param name="d">Direction of the ray.</param>
    /// <param name="n">Shading normal, towards the ray.</param>
    /// <param name="dd">Change of the direction.</param>
    /// <param name="dn">Change of the normal.</param>
    public static (T X, T Y, T Z) Reflect<T>((T X, T Y, T Z) d, (T X, T Y, T Z) n, (T X, T Y, T Z) dd, (T X, T Y, T Z) dn)
        where T : unmanaged, IReal<T>
    {
        T minusTwo = T.Of(-2);
        T turn = minusTwo * Dot(d, n), change = minusTwo * (Dot(dd, n) + Dot(d, dn));
        return (Sum(dd.X, turn, dn.X, change, n.X), Sum(dd.Y, turn, dn.Y, change, n.Y), Sum(dd.Z, turn, dn.Z, change, n.Z));
    }

    /// <summary>Refracted: r d + (r c - c') n with c = -d . n, c' = sqrt(1 - r² (1 - c²)), differentiated.</summary>
    /// <param name="ratio">r: index on the ray's side divided by index behind the surface.</param>
    /// <param name="d">Direction of the ray.</param>
    /// <param name="n">Shading normal, towards the ray.</param>
    /// <param name="dd">Change of the direction.</param>
    /// <param name="dn">Change of the normal.</param>
    public static (T X, T Y, T Z) Refract<T>(T ratio, (T X, T Y, T Z) d, (T X, T Y, T Z) n, (T X, T Y, T Z) dd, (T X, T Y, T Z) dn)
        where T : unmanaged, IReal<T>
    {
        T cosNear = -Dot(d, n), one = T.Of(1);
        T cosFar = T.Sqrt(T.Max(one - (ratio * ratio * (one - (cosNear * cosNear))), T.Of(LeastCosine * LeastCosine)));
        T change = -(Dot(dd, n) + Dot(d, dn)) * (ratio - (ratio * ratio * cosNear / cosFar));
        T along = (ratio * cosNear) - cosFar;
        return (
            Sum(ratio * dd.X, along, dn.X, change, n.X), Sum(ratio * dd.Y, along, dn.Y, change, n.Y), Sum(ratio * dd.Z, along, dn.Z, change, n.Z));
    }

    private static T Sum<T>(T a, T b, T x, T c, T y)
        where T : unmanaged, IReal<T> => T.Fma(b, x, T.Fma(c, y, a));

    private static T Dot<T>((T X, T Y, T Z) a, (T X, T Y, T Z) b)
        where T : unmanaged, IReal<T> => Lane.Dot(a.X, a.Y, a.Z, b.X, b.Y, b.Z);
}
