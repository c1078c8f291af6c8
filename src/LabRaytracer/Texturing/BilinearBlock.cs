using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Where a few groups of lanes read a picture: which texels, and how much of each. Lives on the stack.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
/// <typeparam name="I">Integer lanes.</typeparam>
/// <remarks>
/// Finding texels and reading them are two loops: so the memory has time to bring the texels of one group while the next one is located.
/// </remarks>
internal readonly unsafe struct BilinearBlock<F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Groups of lanes in a block.</summary>
    public const int Packets = 8;

    private const int Columns = 6;
    private readonly F* _memory;

    /// <param name="memory">Room for <see cref="Size"/> groups of lanes.</param>
    public BilinearBlock(F* memory) => _memory = memory;

    /// <summary>Groups of lanes that a block takes in memory.</summary>
    public static int Size => Packets * Columns;

    /// <summary>Element numbers of the left texels of the lower row.</summary>
    public I* Below
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (I*)_memory;
    }

    /// <summary>Element numbers of the left texels of the upper row.</summary>
    public I* Above
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (I*)(_memory + Packets);
    }

    /// <summary>From the left texel to the right one: 1, less where they wrap around or the edge repeats.</summary>
    public I* Across
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (I*)(_memory + (2 * Packets));
    }

    /// <summary>Weights of the right texels.</summary>
    public F* WeightRight
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _memory + (3 * Packets);
    }

    /// <summary>Weights of the upper row.</summary>
    public F* WeightAbove
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _memory + (4 * Packets);
    }

    /// <summary>Mask of the lanes inside the picture.</summary>
    public F* Inside
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => _memory + (5 * Packets);
    }
}
