using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>Some of eight lanes in a row, without a branch that depends on which they are.</summary>
internal static class LanePlaces
{
    /// <summary>Lists the bits that are set.</summary>
    /// <param name="bits">Eight bits.</param>
    /// <returns>Their numbers, a byte each, the least first; then zeros.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static ulong Of(uint bits)
    {
        if (Bmi2.X64.IsSupported)
        {
            return Bmi2.X64.ParallelBitExtract(0x0706050403020100, Bmi2.X64.ParallelBitDeposit(bits, 0x0101010101010101) * 0xFF);
        }

        ulong places = 0;
        for (int at = 0; bits != 0; bits &= bits - 1, at += 8)
        {
            places |= (ulong)BitOperations.TrailingZeroCount(bits) << at;
        }

        return places;
    }
}
