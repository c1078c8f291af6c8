using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Changes of shading normals in world space.</summary>
internal static unsafe class NormalSteps
{
    /// <summary>Writes the changes of one group of lanes.</summary>
    /// <param name="frame">World space to unit form.</param>
    /// <param name="normal">Normals of the unit form and their changes.</param>
    /// <param name="surfaces">Shading normals, world space, length 1, of either sign.</param>
    /// <param name="packet">Group of lanes.</param>
    /// <param name="mask">Lanes to write.</param>
    /// <param name="result">Receives the changes.</param>
    /// <remarks>
    /// With g = transposed frame times normal and h = transposed frame times its change, the unit normal is s = g / |g| (or its reverse) and its change
    /// (h - (s . h) s) / (s . g), whatever the length and the sign.
    /// </remarks>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Store<R, F, I>(
        in LinearLanes<R> frame, in NormalLanes<R> normal, SurfaceBatch<R, F, I> surfaces, int packet, F mask, in VectorColumns<F> result)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        (R gx, R gy, R gz) = frame.ApplyTransposed(normal.X, normal.Y, normal.Z);
        (R hx, R hy, R hz) = frame.ApplyTransposed(normal.StepX, normal.StepY, normal.StepZ);
        R sx = surfaces.ShadingX[packet], sy = surfaces.ShadingY[packet], sz = surfaces.ShadingZ[packet];
        R length = Lane.Dot(gx, gy, gz, sx, sy, sz);
        R along = -Lane.Dot(hx, hy, hz, sx, sy, sz);

        // Normals that cancel have no direction, and theirs does not change.
        R toUnit = R.Select(R.Equal(length, R.Zero), R.Zero, R.Of(1) / length);
        result.Merge(
            packet,
            mask,
            R.ToSingle(R.Fma(along, sx, hx) * toUnit),
            R.ToSingle(R.Fma(along, sy, hy) * toUnit),
            R.ToSingle(R.Fma(along, sz, hz) * toUnit));
    }
}
