using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>
/// Where a group of lanes of a pencil meets a triangle: w lies between <see cref="VolumeLow"/> / <see cref="Sum"/> and <see cref="VolumeHigh"/> / (<see cref="Sum"/> - <see cref="SumError"/>), if that is above 0.
/// </summary>
/// <typeparam name="F">Float lanes.</typeparam>
internal ref struct PencilHits<F>
    where F : unmanaged, IReal<F>
{
    /// <summary>Mask of lanes that may hit the triangle.</summary>
    public F Possible;

    /// <summary>Mask of lanes that certainly hit it, if what they hit is within their limits.</summary>
    public F Certain;

    /// <summary>Upper bound of the sum of the edge functions, which is the scalar product of direction and normal.</summary>
    public F Sum;

    /// <summary>The sum is at most this much smaller, in every lane.</summary>
    public F SumError;

    /// <summary>Bounds of the scalar product of apex to triangle and normal, in every lane.</summary>
    public F VolumeLow, VolumeHigh;

    /// <summary>Mask of possible hits that are not certainly farther than a w.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly F PossibleBefore(F far) => Possible & F.LessOrEqual(VolumeLow, far * Sum);
}
