using System.Numerics;

namespace LabRaytracer;

/// <summary>One or several 32-bit integers side by side: indices of texels, rays, primitives.</summary>
/// <typeparam name="I">The implementing lane type.</typeparam>
/// <remarks>Arithmetic wraps. A mask has all bits of a lane set (true) or none (false).</remarks>
internal interface IIndexLane<I> :
    IAdditionOperators<I, I, I>, ISubtractionOperators<I, I, I>, IMultiplyOperators<I, I, I>, IBitwiseOperators<I, I, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Number of lanes.</summary>
    static abstract int Width { get; }

    /// <summary>The same integer in every lane.</summary>
    static abstract I Of(int value);

    /// <summary>The integers <c>start, start + 1, ...</c>.</summary>
    static abstract I Iota(int start);

    /// <summary>The smaller one, lane by lane.</summary>
    static abstract I Min(I a, I b);

    /// <summary>The larger one, lane by lane.</summary>
    static abstract I Max(I a, I b);

    /// <summary>Mask of <c>a &lt; b</c>.</summary>
    static abstract I Less(I a, I b);

    /// <summary>Mask of equality.</summary>
    static abstract I Equal(I a, I b);

    /// <summary>Tells whether every lane holds a value.</summary>
    static abstract bool AllEqual(I a, int value);

    /// <summary><paramref name="yes"/> where the mask is true, else <paramref name="no"/>.</summary>
    static abstract I Select(I mask, I yes, I no);

    /// <summary>Logical shift to the right, filling with zeros.</summary>
    static abstract I ShiftRight(I a, int bits);

    /// <summary>The integer in one lane.</summary>
    static abstract int Get(I a, int lane);

    /// <summary>Elements <c>table[index[lane]]</c>.</summary>
    static abstract unsafe I Gather(int* table, I index);

    /// <summary>Elements <c>table[index[lane]]</c> and <c>table[index[lane] + 1]</c>.</summary>
    /// <param name="table">The table.</param>
    /// <param name="index">Numbers of the first elements, in memory.</param>
    /// <param name="first">The elements.</param>
    /// <param name="second">Their right neighbours.</param>
    static abstract unsafe void LoadPairs(int* table, I* index, out I first, out I second);

    /// <summary>32 bits from each of some places, and 32 bits from three bytes behind each: two neighbouring colours of three bytes, and another byte above each.</summary>
    /// <param name="table">The bytes.</param>
    /// <param name="offset">Places, bytes; in memory. Eight bytes are read at each.</param>
    /// <param name="first">The bits.</param>
    /// <param name="second">Those three bytes behind.</param>
    static abstract unsafe void LoadTriples(byte* table, I* offset, out I first, out I second);

    /// <summary>Reads a whole group of lanes from memory of any alignment.</summary>
    static abstract unsafe I Load(int* elements);

    /// <summary>Writes a whole group of lanes to memory of any alignment.</summary>
    static abstract unsafe void Store(I a, int* elements);
}
