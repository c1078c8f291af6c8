using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Parts of a pencil, each a group of lanes: which of its triangles each part may hit, all pairs at once.</summary>
/// <remarks>
/// <para>A part's slopes are a rectangle around a middle; an edge function is largest in one of its corners. Lanes are pairs, triangle k mod 4 with part k / 4.</para>
/// <para>What is found is below the true largest value by at most 7 u times what an edge function adds up (<see cref="PencilTriangles"/>): roundings of the coefficients, of middle
/// and differences, and four more. Edge functions are raised by at least 16 u times that, beside the slack of the exact test.</para>
/// </remarks>
internal static unsafe class PencilParts
{
    /// <summary>Vectors of floats a group of parts: middle of the slopes along x, along y, and their largest differences from it.</summary>
    public const int Numbers = 4;

    private const uint EachPart = 0x11111111;

    /// <summary>Vectors of floats that a pencil needs.</summary>
    /// <param name="parts">Its number of parts.</param>
    public static int Room<F>(int parts)
        where F : unmanaged, IReal<F> => Numbers * Groups<F>(parts);

    /// <summary>Groups of parts, each as many as a vector has room for with all triangles of a leaf.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int Groups<F>(int parts)
        where F : unmanaged, IReal<F> => ((PencilTriangles.Most * parts) + F.Width - 1) / F.Width;

    /// <summary>Sets all parts to such as hit nothing.</summary>
    public static void Clear<F>(F* parts, int count)
        where F : unmanaged, IReal<F> => new Span<float>(parts, F.Width * Room<F>(count)).Fill(float.NaN);

    /// <summary>Sets the rectangle of one part, if it has any rays.</summary>
    /// <param name="parts">The numbers of all parts.</param>
    /// <param name="part">Which one.</param>
    /// <param name="slopes">Its slopes.</param>
    /// <param name="pencil">The pencil, from whose middle slopes are counted.</param>
    /// <param name="rounding">By how much bounds may be wrong.</param>
    public static void Set<F>(F* parts, int part, in SlopeBounds slopes, in RayPencil pencil, double rounding)
        where F : unmanaged, IReal<F>
    {
        if (F.Width < PencilTriangles.Most || slopes.IsEmpty)
        {
            return;
        }

        int first = PencilTriangles.Most * part;
        float* to = (float*)(parts + (Numbers * (first / F.Width))) + (first % F.Width);
        *(Float4*)to = Float4.Of(slopes.MiddleX - pencil.MiddleX);
        *(Float4*)(to + F.Width) = Float4.Of(slopes.MiddleY - pencil.MiddleY);
        *(Float4*)(to + (2 * F.Width)) = Float4.Of(slopes.SpreadX + rounding);
        *(Float4*)(to + (3 * F.Width)) = Float4.Of(slopes.SpreadY + rounding);
    }

    /// <summary>Bits of the pairs of a group of parts that may hit each other.</summary>
    /// <param name="parts">The group's numbers.</param>
    /// <param name="columns">The triangles, prepared.</param>
    /// <param name="left">Bits of the triangles that the pencil may hit.</param>
    /// <param name="group">Which group it is.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Meet<F>(F* parts, float* columns, uint left, int group)
        where F : unmanaged, IReal<F>
    {
        if (F.Width < PencilTriangles.Most)
        {
            return (left >> (group * F.Width % PencilTriangles.Most)) & ((1u << F.Width) - 1);
        }

        const int Next = PencilTriangles.EdgeNumbers * PencilTriangles.Most;
        F x = parts[0], y = parts[1], spreadX = parts[2], spreadY = parts[3];
        F largest = F.Min(F.Min(Largest(x, y, spreadX, spreadY, columns), Largest(x, y, spreadX, spreadY, columns + Next)), Largest(x, y, spreadX, spreadY, columns + (2 * Next)));
        return F.Bits(F.LessOrEqual(F.Zero, largest)) & (left * EachPart);
    }

    /// <summary>The largest value of an edge function in each part.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Largest<F>(F x, F y, F spreadX, F spreadY, float* edge)
        where F : unmanaged, IReal<F>
    {
        F edgeX = LaneFours.Repeat<F>(edge + (PencilTriangles.EdgeX * PencilTriangles.Most)), edgeY = LaneFours.Repeat<F>(edge + (PencilTriangles.EdgeY * PencilTriangles.Most));
        F inMiddle = F.Fma(x, edgeX, F.Fma(y, edgeY, LaneFours.Repeat<F>(edge + (PencilTriangles.EdgeMiddle * PencilTriangles.Most))));
        return F.Fma(spreadX, F.Abs(edgeX), F.Fma(spreadY, F.Abs(edgeY), inMiddle));
    }
}
