using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>What is known of the footprints of a group of lookups before a texel of them is read. Lives on the stack.</summary>
/// <typeparam name="F">Float lanes.</typeparam>
/// <remarks>Two of them take turns: while the texels of one are summed, the memory brings those of the next.</remarks>
/// <param name="memory">Room for <see cref="Size"/> groups of lanes.</param>
internal readonly unsafe struct EwaGroup<F>(F* memory)
    where F : unmanaged, IReal<F>
{
    /// <summary>Groups of lanes that it takes in memory.</summary>
    public const int Size = 3 + EwaKernel.Numbers + EwaPlace.Numbers + EwaRows.Numbers;

    /// <summary>Mask of the lookups that are averaged.</summary>
    public F* IsLarge
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => memory;
    }

    /// <summary>Mask of those whose texels all lie inside the level.</summary>
    public F* IsInner
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => memory + 1;
    }

    /// <summary>How much the mean counts beside the bilinear colour; all where it is 1 or more.</summary>
    public F* Share
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => memory + 2;
    }

    /// <summary>Weights: what <see cref="EwaKernel.Store"/> writes.</summary>
    public F* Kernels
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => memory + 3;
    }

    /// <summary>Places: what <see cref="EwaPlace.Store"/> writes.</summary>
    public int* Places
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => (int*)(memory + 3 + EwaKernel.Numbers);
    }

    /// <summary>Rows: what <see cref="EwaRows"/> writes.</summary>
    public F* Rows
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => memory + 3 + EwaKernel.Numbers + EwaPlace.Numbers;
    }
}
