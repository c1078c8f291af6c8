using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>Four floats again and again in the lanes of a vector.</summary>
internal static unsafe class LaneFours
{
    /// <summary>Lane k is number k mod 4.</summary>
    /// <param name="four">Four consecutive floats.</param>
    /// <typeparam name="F">Float lanes, at least four.</typeparam>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Repeat<F>(float* four)
        where F : unmanaged, IReal<F>
    {
        if (typeof(F) == typeof(Float16))
        {
            Vector512<float> repeated = Avx512F.IsSupported
                ? Avx512F.BroadcastVector128ToVector512(four)
                : Vector512.Create(Vector256.Create(Vector128.Load(four), Vector128.Load(four)), Vector256.Create(Vector128.Load(four), Vector128.Load(four)));
            return Unsafe.BitCast<Float16, F>(new(repeated));
        }

        if (typeof(F) == typeof(Float8))
        {
            return Unsafe.BitCast<Float8, F>(new(Avx.IsSupported ? Avx.BroadcastVector128ToVector256(four) : Vector256.Create(Vector128.Load(four), Vector128.Load(four))));
        }

        return *(F*)four;
    }
}
