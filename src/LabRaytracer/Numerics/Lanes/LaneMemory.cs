using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>Columns of lanes in memory outside the garbage collector, aligned to cache lines; freed together.</summary>
/// <remarks>Not thread safe: every worker owns one.</remarks>
internal sealed unsafe class LaneMemory : IDisposable
{
    private const nuint Alignment = 64;
    private readonly List<nint> _blocks = [];

    /// <summary>Frees what <see cref="Dispose"/> was not called for.</summary>
    ~LaneMemory() => Free();

    /// <summary>Bytes allocated so far.</summary>
    public long Bytes { get; private set; }

    /// <summary>A new column, zeroed, that holds at least a number of scalars, rounded up to whole lanes plus one spare.</summary>
    /// <typeparam name="T">A lane type, or a scalar.</typeparam>
    /// <param name="elements">Scalars that fit.</param>
    /// <param name="width">Scalars in one <typeparamref name="T"/>.</param>
    public T* Column<T>(int elements, int width)
        where T : unmanaged
    {
        nuint bytes = (nuint)(((elements + width - 1) / width) + 1) * (nuint)sizeof(T);
        void* block = NativeMemory.AlignedAlloc(bytes, Alignment);
        NativeMemory.Clear(block, bytes);
        _blocks.Add((nint)block);
        Bytes += (long)bytes;
        return (T*)block;
    }

    public void Dispose()
    {
        Free();
        GC.SuppressFinalize(this);
    }

    private void Free()
    {
        foreach (nint block in _blocks)
        {
            NativeMemory.AlignedFree((void*)block);
        }

        _blocks.Clear();
    }
}
