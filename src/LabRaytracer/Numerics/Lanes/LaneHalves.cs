using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace LabRaytracer;

/// <summary>Vectors made of two halves.</summary>
internal static class LaneHalves
{
    /// <summary>The vector with the given lower and upper half.</summary>
    /// <remarks><c>Vector512.Create</c> inserts both halves into an undefined register, which the compiler saves and restores around loops.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector512<T> Join<T>(Vector256<T> lower, Vector256<T> upper) => lower.ToVector512Unsafe().WithUpper(upper);
}
