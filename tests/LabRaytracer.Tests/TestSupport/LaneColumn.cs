using System.Runtime.InteropServices;

namespace LabRaytracer.Tests;

/// <summary>Scalars in memory, seen as lanes of a type: padded with zeros to whole groups.</summary>
internal sealed unsafe class LaneColumn<R> : IDisposable
    where R : unmanaged, IReal<R>
{
    private readonly byte* _bytes;
    private readonly int _count;

    public LaneColumn(IReadOnlyList<double> numbers)
        : this(numbers.Count)
    {
        for (int i = 0; i < _count; i++)
        {
            this[i] = numbers[i];
        }
    }

    public LaneColumn(int count)
    {
        _count = count;
        Packets = (count + R.Width - 1) / R.Width;
        _bytes = (byte*)NativeMemory.AlignedAlloc((nuint)(Packets * sizeof(R)), 64);
        NativeMemory.Clear(_bytes, (nuint)(Packets * sizeof(R)));
    }

    ~LaneColumn() => NativeMemory.AlignedFree(_bytes);

    public int Packets { get; }

    public R* Lanes => (R*)_bytes;

    public double this[int element]
    {
        get => R.IsSingle ? ((float*)_bytes)[element] : ((double*)_bytes)[element];
        set
        {
            if (R.IsSingle)
            {
                ((float*)_bytes)[element] = (float)value;
            }
            else
            {
                ((double*)_bytes)[element] = value;
            }
        }
    }

    public double[] ToArray() => [.. Enumerable.Range(0, _count).Select(i => this[i])];

    public void Dispose()
    {
        NativeMemory.AlignedFree(_bytes);
        GC.SuppressFinalize(this);
    }
}
