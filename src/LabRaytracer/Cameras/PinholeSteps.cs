using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>How the rays of a pinhole camera change from one sample to the next: the same for all of them, as long as directions are not made 1 long.</summary>
/// <param name="Forward">Line of sight, world space, length 1: before it is made 1 long, a direction d is 1 / (d . forward) long.</param>
/// <param name="Right">Change of such a direction over a sample to the right, world space.</param>
/// <param name="Down">Change of it over a sample down.</param>
internal readonly record struct PinholeSteps(Vector3D Forward, Vector3D Right, Vector3D Down)
{
    /// <summary>Differentials of the rays with given directions.</summary>
    /// <param name="directions">Directions, length 1.</param>
    /// <param name="differentials">Where the differentials go.</param>
    /// <param name="packets">Groups of lanes.</param>
    /// <remarks>With D = f + a r + b u and d = D / |D|, d' = (D' - (d . D') d) / |D|, where 1 / |D| = d . f.</remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public unsafe void Write<T>(in VectorColumns<T> directions, in DifferentialColumns<T> differentials, int packets)
        where T : unmanaged, IReal<T>
    {
        VectorColumns<T> d = directions;
        for (int packet = 0; packet < packets; packet++)
        {
            T x = d.X[packet], y = d.Y[packet], z = d.Z[packet];
            T inverse = Lane.Dot(x, y, z, T.Of(Forward.X), T.Of(Forward.Y), T.Of(Forward.Z));
            Turn(differentials.DirectionDx, packet, x, y, z, Right, inverse);
            Turn(differentials.DirectionDy, packet, x, y, z, Down, inverse);
            differentials.OriginDx.Store(packet, T.Zero, T.Zero, T.Zero);
            differentials.OriginDy.Store(packet, T.Zero, T.Zero, T.Zero);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Turn<T>(in VectorColumns<T> result, int packet, T x, T y, T z, Vector3D step, T inverse)
        where T : unmanaged, IReal<T>
    {
        T sx = T.Of(step.X), sy = T.Of(step.Y), sz = T.Of(step.Z);
        T along = -Lane.Dot(x, y, z, sx, sy, sz);
        result.Store(packet, T.Fma(along, x, sx) * inverse, T.Fma(along, y, sy) * inverse, T.Fma(along, z, sz) * inverse);
    }
}
