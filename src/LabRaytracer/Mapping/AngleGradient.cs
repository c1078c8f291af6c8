using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The gradient of u = atan2(x, z) / 2 pi, which is the same on both sides of the seam.</summary>
/// <typeparam name="T">Lane type.</typeparam>
internal readonly struct AngleGradient<T>
    where T : unmanaged, IReal<T>
{
    /// <summary>A distance from the axis below this one counts as this one: there the gradient has its bound instead of growing without end.</summary>
    public const double LeastDistance = 1.0 / (1 << 20);

    private const double InverseTwoPi = 0.15915494309189535;

    /// <summary>sin(phi) = x / rho and cos(phi) = z / rho; 0 and 1 on the axis.</summary>
    public readonly T Sin, Cos;

    /// <summary>Components of the gradient; along y it is 0.</summary>
    public readonly T X, Z;

    /// <param name="x">Coordinate whose axis is a quarter turn from the seam.</param>
    /// <param name="z">Coordinate whose axis runs through the seam.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public AngleGradient(T x, T z)
    {
        // Scaled by the larger coordinate, squares neither overflow nor vanish.
        T size = T.Max(T.Abs(x), T.Abs(z));
        T isOnAxis = T.Less(size, T.Of(T.IsSingle ? 1e-30 : 1e-300));
        T toUnit = T.Of(1) / T.Select(isOnAxis, T.Of(1), size);
        x *= toUnit;
        z *= toUnit;
        T distance = T.Sqrt(T.Fma(x, x, z * z));
        T inverse = T.Of(1) / T.Select(isOnAxis, T.Of(1), distance);
        Sin = T.Select(isOnAxis, T.Zero, x * inverse);
        Cos = T.Select(isOnAxis, T.Of(1), z * inverse);
        T slope = T.Of(InverseTwoPi) / T.Max(distance * size, T.Of(LeastDistance));
        X = Cos * slope;
        Z = -Sin * slope;
    }
}
