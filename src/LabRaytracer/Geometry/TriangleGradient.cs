using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>How fast the weights of a triangle's second and third vertex change with the point: zero for triangles without area.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <remarks>With edges e, f from the first vertex and n = e x f: f x n / n² and n x e / n².</remarks>
internal readonly struct TriangleGradient<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Gradient of the weight of the second vertex.</summary>
    public readonly R SecondX, SecondY, SecondZ;

    /// <summary>Gradient of the weight of the third vertex.</summary>
    public readonly R ThirdX, ThirdY, ThirdZ;

    /// <param name="ex">Edge to the second vertex.</param>
    /// <param name="ey">Edge to the second vertex.</param>
    /// <param name="ez">Edge to the second vertex.</param>
    /// <param name="fx">Edge to the third vertex.</param>
    /// <param name="fy">Edge to the third vertex.</param>
    /// <param name="fz">Edge to the third vertex.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public TriangleGradient(R ex, R ey, R ez, R fx, R fy, R fz)
    {
        R nx = R.Fma(ey, fz, -(ez * fy)), ny = R.Fma(ez, fx, -(ex * fz)), nz = R.Fma(ex, fy, -(ey * fx));
        R square = Lane.Dot(nx, ny, nz, nx, ny, nz);
        R inverse = R.Select(R.Equal(square, R.Zero), R.Zero, R.Of(1) / square);
        SecondX = R.Fma(fy, nz, -(fz * ny)) * inverse;
        SecondY = R.Fma(fz, nx, -(fx * nz)) * inverse;
        SecondZ = R.Fma(fx, ny, -(fy * nx)) * inverse;
        ThirdX = R.Fma(ny, ez, -(nz * ey)) * inverse;
        ThirdY = R.Fma(nz, ex, -(nx * ez)) * inverse;
        ThirdZ = R.Fma(nx, ey, -(ny * ex)) * inverse;
    }

    /// <summary>Gradient of a number that changes linearly, by its changes towards the second and third vertex.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (R X, R Y, R Z) Of(R toSecond, R toThird) => (
        R.Fma(toSecond, SecondX, toThird * ThirdX), R.Fma(toSecond, SecondY, toThird * ThirdY), R.Fma(toSecond, SecondZ, toThird * ThirdZ));
}
