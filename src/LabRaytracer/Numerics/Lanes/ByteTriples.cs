using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace LabRaytracer;

/// <summary>Colours of three bytes, written without the fourth one.</summary>
internal static unsafe class ByteTriples
{
    /// <summary>Writes the first three bytes of 20 elements of four; four more bytes behind them are overwritten.</summary>
    /// <param name="from">The elements.</param>
    /// <param name="to">Room for 64 bytes.</param>
    public static void PackTwenty(int* from, byte* to)
    {
        for (int k = 0; k < 20; k += 4)
        {
            Pack(Vector128.Load(from + k).AsByte()).Store(to + (3 * k));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<byte> Pack(Vector128<byte> four) =>
        Vector128.Shuffle(four, Vector128.Create((byte)0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, 255, 255, 255, 255));
}
