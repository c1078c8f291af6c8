using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Triangles against a pencil of rays: what is the same for all its rays, for up to four triangles at a time.</summary>
/// <remarks>
/// <para>With the vertices p0, p1, p2 relative to the apex, a line along d meets the triangle where d (p1 x p2), d (p2 x p0) and d (p0 x p1) have the same sign: three linear
/// functions of the slopes. Their coefficients are computed in doubles and flipped so that hits are positive; over the small differences of slopes floats are enough
/// to evaluate them. The sum of the three is d N with N the normal (twice the area), and w = p0 N / d N.</para>
/// <para>Error bound of an edge function, against the sign that <see cref="WatertightTriangle"/> finds in doubles (u = 2^-24, D the size of the pencil): the evaluation in floats,
/// less than 8 u (|middle| + span), taken twice; the set-up 2^-47 D^2; the test's own sheared vertices, each wrong by up to 2^-51 D, times how far vertices are beside the rays,
/// 2^-47 D^2; lines that pass the apex, 32 D times how far. The last three are multiplied by 8, as much as shearing may add, and more.</para>
/// <para>In float lanes, the evaluation counts four times, as the test's distance has 16 roundings of its own; the rest is in <see cref="PencilErrors"/>.</para>
/// </remarks>
internal static unsafe class PencilTriangles
{
    /// <summary>Numbers a triangle; each has a column of four.</summary>
    public const int Numbers = 15;

    /// <summary>Columns of an edge function: x, y and middle coefficient, the last raised by the error bound, and twice that bound.</summary>
    public const int EdgeX = 0, EdgeY = 1, EdgeMiddle = 2, EdgeError = 3, EdgeNumbers = 4;

    /// <summary>Columns behind the three edge functions: how much smaller than the sum of the raised ones the true sum may be, and bounds of the volume.</summary>
    public const int SumError = 12, VolumeLow = 13, VolumeHigh = 14;

    /// <summary>Triangles that are prepared at a time.</summary>
    public const int Most = BvhWide.MostItems;

    private const double EvaluationDouble = 1.0 / (1 << 20), EvaluationSingle = 1.0 / (1 << 19);
    private const double Rounding = 1.0 / (1 << 20);

    /// <summary>Prepares triangles.</summary>
    /// <param name="pencil">The rays.</param>
    /// <param name="triangles">The first triangle.</param>
    /// <param name="count">How many, 1 to 4.</param>
    /// <param name="positions">Their vertices.</param>
    /// <param name="columns">Receives <see cref="Numbers"/> columns of four floats.</param>
    /// <returns>Bits of the triangles that some ray may hit.</returns>
    [SkipLocalsInit]
    public static uint Prepare<R, P>(in RayPencil pencil, MeshTriangle* triangles, int count, P positions, float* columns)
        where R : unmanaged, IReal<R>
        where P : struct, IMeshPositions
    {
        if (!R.IsSingle)
        {
            return PrepareDoubles(pencil, triangles, count, positions, columns);
        }

        // Methods of their own, each small enough for the compiler to inline what it calls.
        Unsafe.SkipInit(out PencilCorners corners);
        corners.Load(pencil, triangles, count, positions);
        return PrepareSingles(pencil, corners, count, columns);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static uint PrepareDoubles<P>(in RayPencil pencil, MeshTriangle* triangles, int count, P positions, float* columns)
        where P : struct, IMeshPositions
    {
        PencilCorners.Load(pencil, triangles, count, positions, out Double4 x0, out Double4 y0, out Double4 z0, out Double4 x1, out Double4 y1, out Double4 z1, out Double4 x2, out Double4 y2, out Double4 z2);
        return Prepare(pencil, x0, y0, z0, x1, y1, z1, x2, y2, z2, EvaluationDouble, Double4.Of(pencil.Slack), Double4.Of(pencil.Size), count, columns);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static uint PrepareSingles(in RayPencil pencil, in PencilCorners corners, int count, float* columns) => Prepare(
        pencil, corners.X0, corners.Y0, corners.Z0, corners.X1, corners.Y1, corners.Z1, corners.X2, corners.Y2, corners.Z2, EvaluationSingle, corners.Error, corners.Reach, count, columns);

    /// <summary>Prepares triangles: edge functions are wrong by a part of what they add up and by a slack, the volume by a reach times the sum of their errors.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Prepare(
        in RayPencil pencil, Double4 x0, Double4 y0, Double4 z0, Double4 x1, Double4 y1, Double4 z1, Double4 x2, Double4 y2, Double4 z2,
        double evaluation, Double4 slack, Double4 reach, int count, float* columns)
    {
        Double4 volume = Lane.Dot(x0, y0, z0, Minor(y1, z2, z1, y2), Minor(z1, x2, x1, z2), Minor(x1, y2, y1, x2));
        Double4 sign = volume & Double4.Of(-0.0), isOutside = default, isOutsideReversed = default, sumError = default;
        AddEdge(pencil, sign, x1, y1, z1, x2, y2, z2, evaluation, slack, columns, ref isOutside, ref isOutsideReversed, ref sumError);
        AddEdge(pencil, sign, x2, y2, z2, x0, y0, z0, evaluation, slack, columns + (EdgeNumbers * Most), ref isOutside, ref isOutsideReversed, ref sumError);
        AddEdge(pencil, sign, x0, y0, z0, x1, y1, z1, evaluation, slack, columns + (2 * EdgeNumbers * Most), ref isOutside, ref isOutsideReversed, ref sumError);
        Double4 size = Double4.Abs(volume), volumeError = sumError * reach, isKnown = Double4.Less(volumeError, size);
        uint left = ~Double4.Bits(isOutside & (isKnown | isOutsideReversed)) & ((1u << count) - 1);
        if (left == 0)
        {
            return 0;
        }

        // Triangles near the apex or behind it are left to the exact test.
        Double4 isBefore = Double4.Less(Double4.Of(pencil.Nearest), Double4.Min(Double4.Min(z0, z1), z2));
        Store(columns, SumError, sumError * Double4.Of(3 * (1 + Rounding)));
        Store(columns, VolumeLow, (size - volumeError) * Double4.Of(1 - Rounding));
        Store(columns, VolumeHigh, Double4.Select(isBefore, (size + volumeError) * Double4.Of(1 + Rounding), Double4.Of(double.PositiveInfinity)));
        uint unknown = left & ~Double4.Bits(isKnown);
        if (unknown != 0)
        {
            Forget(columns, unknown);
        }

        return left;
    }

    /// <summary>Writes edge functions that are positive everywhere for triangles of which nothing is known, so that the exact test decides: which side of them the apex is on is open.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Forget(float* columns, uint unknown)
    {
        for (; unknown != 0; unknown &= unknown - 1)
        {
            float* own = columns + BitOperations.TrailingZeroCount(unknown);
            for (int edge = 0; edge < 3; edge++, own += EdgeNumbers * Most)
            {
                own[EdgeX * Most] = own[EdgeY * Most] = 0;
                own[EdgeMiddle * Most] = own[EdgeError * Most];
            }

            own[(VolumeLow - (3 * EdgeNumbers)) * Most] = float.NegativeInfinity;
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Store(float* columns, int column, Double4 numbers) => ((Float4*)columns)[column] = Double4.ToSingle(numbers);

    /// <summary>a d - b c.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Double4 Minor(Double4 a, Double4 d, Double4 b, Double4 c) => Double4.Fma(a, d, -(b * c));

    /// <summary>Computes and writes one edge function: the scalar product of direction and cross product of two vertices.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AddEdge(
        in RayPencil pencil, Double4 sign, Double4 x1, Double4 y1, Double4 z1, Double4 x2, Double4 y2, Double4 z2, double evaluation, Double4 slack, float* columns,
        ref Double4 isOutside, ref Double4 isOutsideReversed, ref Double4 sumError)
    {
        Double4 y = Minor(z1, x2, x1, z2) ^ sign, z = Minor(x1, y2, y1, x2) ^ sign;
        Double4 x = Double4.Fma(y, Double4.Of(pencil.Shear), Minor(y1, z2, z1, y2) ^ sign);
        Double4 middle = Double4.Fma(x, Double4.Of(pencil.MiddleX), Double4.Fma(y, Double4.Of(pencil.MiddleY), z));
        Double4 span = Double4.Fma(Double4.Abs(x), Double4.Of(pencil.SpreadX), Double4.Abs(y) * Double4.Of(pencil.SpreadY));
        Double4 error = Double4.Fma(Double4.Abs(middle) + span, Double4.Of(evaluation), slack);
        Double4 raised = middle + error;
        isOutside |= Double4.Less(raised + span, Double4.Zero);
        isOutsideReversed |= Double4.Less(span + error, middle);
        sumError += error;
        Store(columns, EdgeX, x);
        Store(columns, EdgeY, y);
        Store(columns, EdgeMiddle, raised);
        Store(columns, EdgeError, error + error);
    }
}
