using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>Hints about memory.</summary>
internal static unsafe class CacheLine
{
    /// <summary>Asks for the line that holds an address, which will soon be read; changes nothing else.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Prefetch(void* address)
    {
        if (Sse.IsSupported)
        {
            Sse.Prefetch0(address);
        }
    }

    /// <summary>The same into the second-level cache only: more lines can be on their way at once than into the first, and those that are read now stay there.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void PrefetchFar(void* address)
    {
        if (Sse.IsSupported)
        {
            Sse.Prefetch1(address);
        }
    }
}
