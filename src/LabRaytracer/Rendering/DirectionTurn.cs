using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Rotations of directions in lanes.</summary>
internal static class DirectionTurn
{
    /// <summary>The product of the linear part of a matrix with vectors.</summary>
    /// <param name="rows">12 numbers, row after row of four.</param>
    /// <param name="x">First coordinate.</param>
    /// <param name="y">Second coordinate.</param>
    /// <param name="z">Third coordinate.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static (R X, R Y, R Z) Apply<R>(ReadOnlySpan<double> rows, R x, R y, R z)
        where R : unmanaged, IReal<R> => (
            Lane.Dot(R.Of(rows[0]), R.Of(rows[1]), R.Of(rows[2]), x, y, z),
            Lane.Dot(R.Of(rows[4]), R.Of(rows[5]), R.Of(rows[6]), x, y, z),
            Lane.Dot(R.Of(rows[8]), R.Of(rows[9]), R.Of(rows[10]), x, y, z));
}
