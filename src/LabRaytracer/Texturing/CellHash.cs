using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Random bits for the cells of a lattice: functions of the cell's numbers and a seed, the same on every machine.</summary>
/// <remarks>
/// Integer arithmetic instead of a table of permutations: wide registers multiply faster than they look things up, and nothing repeats every 256 cells.
/// The mixing step is the published "lowbias32" (C. Wellons, hash prospector): every bit of the argument changes every bit of the result with a probability near 1/2.
/// </remarks>
internal static class CellHash
{
    /// <summary>Factors of the three numbers of a cell: odd, so that no bit is lost.</summary>
    private const int FactorX = unchecked((int)0x9E3779B1), FactorY = unchecked((int)0x85EBCA77), FactorZ = unchecked((int)0xC2B2AE3D);

    /// <summary>Bits of a cell, given those of its x and the step of its y and z.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static I Of<I>(I column, I step)
        where I : unmanaged, IIndexLane<I> => Mix(column ^ step);

    /// <summary>Bits of the x number of a cell.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static I Column<I>(I x, int key)
        where I : unmanaged, IIndexLane<I> => Mix((x * I.Of(FactorX)) + I.Of(key));

    /// <summary>What the y and z numbers of a cell add.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static I Step<I>(I y, I z)
        where I : unmanaged, IIndexLane<I> => (y * I.Of(FactorY)) + (z * I.Of(FactorZ));

    /// <summary>The key of one layer of a seeded pattern.</summary>
    public static int Key(int seed, int layer) => Mix(Mix(new Int1(seed)) + new Int1(layer * FactorX)).Value;

    /// <summary>The upper 24 bits as a number in [0, 1); exact in either precision.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F ToUnit<F, I>(I bits)
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => F.FromInt32(I.ShiftRight(bits, 8)) * F.Of(1.0 / (1 << 24));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static I Mix<I>(I bits)
        where I : unmanaged, IIndexLane<I>
    {
        bits = (bits ^ I.ShiftRight(bits, 16)) * I.Of(0x7FEB352D);
        bits = (bits ^ I.ShiftRight(bits, 15)) * I.Of(unchecked((int)0x846CA68B));
        return bits ^ I.ShiftRight(bits, 16);
    }
}
