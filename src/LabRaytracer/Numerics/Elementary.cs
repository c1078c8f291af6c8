using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Elementary functions with the same bits on every machine and at every width.</summary>
/// <remarks>
/// Written once over lanes; only + - * / sqrt, fused multiply-add and selections in a fixed order, all of them correctly rounded.
/// Angles are in turns (1 turn = 2 pi radians = 360 degrees), because texture coordinates are turns and quarter turns are then exact.
/// Coefficients: minimax polynomials made by tests/LabRaytracer.Tests/Oracle/coefficients.py; bounds: tests against a 60-digit oracle.
/// </remarks>
internal static partial class Elementary
{
    /// <summary>The largest number below 1 of a lane's precision.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T BelowOne<T>()
        where T : unmanaged, IReal<T> => T.Of(T.IsSingle ? 0.99999994039535522 : 0.99999999999999989);

    /// <summary>Two to a power that depends on the precision; made of its bits, so that the compiler folds it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static T Power<T>(int single, int twice)
        where T : unmanaged, IReal<T> => T.Of(BitConverter.Int64BitsToDouble((1023L + (T.IsSingle ? single : twice)) << 52));
}
