using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Numbers kept as floats where every one of them is exactly a float, else as doubles.</summary>
internal readonly unsafe struct MeshColumn
{
    /// <summary>Rows that are turned at a time.</summary>
    private const int Rows = 4;

    /// <summary>Numbers behind the last one that may be read: rows of four start at any of them.</summary>
    private const int Spare = 3;

    /// <summary>The numbers as floats, or null.</summary>
    public readonly float* Singles;

    /// <summary>The numbers as doubles, or null.</summary>
    public readonly double* Doubles;

    public MeshColumn(LaneMemory memory, ReadOnlySpan<double> values)
    {
        if (AreSingles(values))
        {
            Singles = memory.Column<float>(values.Length + Spare, 1);
            for (int i = 0; i < values.Length; i++)
            {
                Singles[i] = (float)values[i];
            }
        }
        else
        {
            Doubles = memory.Column<double>(values.Length + Spare, 1);
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

    /// <summary>Three consecutive numbers for each lane: rows are read and turned, which takes fewer instructions than gathering numbers.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    [SkipLocalsInit]
    public void Gather<R, F, I>(in I element, out R first, out R second, out R third)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        if (R.Width < Rows)
        {
            first = Gather<R, F, I>(element);
            second = Gather<R, F, I>(element + I.Of(1));
            third = Gather<R, F, I>(element + I.Of(2));
            return;
        }

        Unsafe.SkipInit(out R x);
        Unsafe.SkipInit(out R y);
        Unsafe.SkipInit(out R z);
        I places = element;
        for (int row = 0; row < R.Width; row += Rows)
        {
            int* at = (int*)&places + row;
            if (R.IsSingle)
            {
                Turn(at[0], at[1], at[2], at[3], out ((Float4*)&x)[row / Rows], out ((Float4*)&y)[row / Rows], out ((Float4*)&z)[row / Rows]);
            }
            else
            {
                Turn(at[0], at[1], at[2], at[3], out ((Double4*)&x)[row / Rows], out ((Double4*)&y)[row / Rows], out ((Double4*)&z)[row / Rows]);
            }
        }

        (first, second, third) = (x, y, z);
    }

    /// <summary>Three consecutive numbers from each of four places.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Turn<Q>(int a, int b, int c, int d, out Q first, out Q second, out Q third)
        where Q : unmanaged, IQuad<Q>
    {
        if (Singles != null)
        {
            Q.Turn(Q.Load(Singles + a), Q.Load(Singles + b), Q.Load(Singles + c), Q.Load(Singles + d), out first, out second, out third);
        }
        else
        {
            Q.Turn(Q.Load(Doubles + a), Q.Load(Doubles + b), Q.Load(Doubles + c), Q.Load(Doubles + d), out first, out second, out third);
        }
    }

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
