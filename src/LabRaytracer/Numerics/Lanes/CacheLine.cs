using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics.X86;

namespace LabRaytracer;

/// <summary>Hints about memory.</summary>
internal static unsafe class CacheLine
{
    /// <summary>Bytes of a line.</summary>
    public const int Bytes = 64;

    /// <summary>The first address in a room that starts a line, so that no vector lies across two: what is on the stack starts anywhere.</summary>
    /// <param name="room">A room, <see cref="Bytes"/> larger than what is put there.</param>
    public static void* Start(byte* room) => (void*)(((nuint)room + Bytes - 1) & ~(nuint)(Bytes - 1));

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
