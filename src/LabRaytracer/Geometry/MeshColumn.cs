using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Numbers kept as floats where every one of them is exactly a float, else as doubles.</summary>
internal readonly unsafe struct MeshColumn
{
    /// <summary>The numbers as floats, or null.</summary>
    public readonly float* Singles;

    /// <summary>The numbers as doubles, or null.</summary>
    public readonly double* Doubles;

    public MeshColumn(LaneMemory memory, ReadOnlySpan<double> values)
    {
        if (AreSingles(values))
        {
            Singles = memory.Column<float>(values.Length, 1);
            for (int i = 0; i < values.Length; i++)
            {
                Singles[i] = (float)values[i];
            }
        }
        else
        {
            Doubles = memory.Column<double>(values.Length, 1);
            values.CopyTo(new Span<double>(Doubles, values.Length));
        }
    }

    /// <summary>Tells whether there are any numbers.</summary>
    public bool IsPresent => Singles != null || Doubles != null;

    /// <summary>One number.</summary>
    public double this[int element]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Singles != null ? Singles[element] : Doubles[element];
    }

    /// <summary>A number for each lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public R Gather<R, F, I>(I element)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> =>
        Singles != null ? R.FromSingle(F.Gather((F*)Singles, element))
        : !R.IsSingle ? R.Gather((R*)Doubles, element)
        : GatherRounded<R, F, I>(element);

    private R GatherRounded<R, F, I>(I element)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R gathered = R.Zero;
        for (int lane = 0; lane < R.Width; lane++)
        {
            R.Put(&gathered, lane, Doubles[I.Get(element, lane)]);
        }

        return gathered;
    }

    private static bool AreSingles(ReadOnlySpan<double> values)
    {
        foreach (double value in values)
        {
            if ((float)value != value)
            {
                return false;
            }
        }

        return true;
    }
}
