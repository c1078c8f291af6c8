using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Triangles against a pencil of rays: what is the same for all its rays, for as many triangles at a time as a vector has lanes.</summary>
/// <remarks>
/// <para>With the vertices p0, p1, p2 relative to the apex, a line along d meets the triangle where d (p1 x p2), d (p2 x p0) and d (p0 x p1) have the same sign: three linear
/// functions of the slopes. The sum of the three is d N with N the normal (twice the area), and w = p0 N / d N. Axes are sheared so that the pencil's middle is z: in doubles, and
/// then rounded to float, vertices are off by little, as what is near the pencil has small x and y. All that follows is in floats: coefficients, flipped so that hits are positive,
/// from one vertex and the way to the next, whose differences are as exact as they are small.</para>
/// <para>Error bound of an edge function (u = 2^-24): with T = |y2 - y1| (|x1| + sx |z1|) + |x2 - x1| (|y1| + sy |z1|) + |z2 - z1| (sx |y1| + sy |x1|), and sx, sy the largest slopes,
/// coefficients are off by at most 3 u T, and their evaluation by 3 u T more, with the roundings of slopes and of the bound itself 8 u T. That is taken twice in double lanes, four
/// times in float lanes, as the test's distance has 16 roundings of its own; the rest is in <see cref="PencilErrors"/>.</para>
/// </remarks>
internal static unsafe class PencilTriangles
{
    /// <summary>Numbers of a triangle's vertices, each a column.</summary>
    public const int VertexNumbers = 9;

    /// <summary>Numbers a triangle; each has a column.</summary>
    public const int Numbers = 19;

    /// <summary>Columns of an edge function: x, y and middle coefficient, the last raised by the error bound, and twice that bound.</summary>
    public const int EdgeX = 0, EdgeY = 1, EdgeMiddle = 2, EdgeError = 3, EdgeNumbers = 4;

    /// <summary>Columns behind the three edge functions: how much smaller than the sum of the raised ones the true sum may be, and bounds of the volume.</summary>
    public const int SumError = 12, VolumeLow = 13, VolumeHigh = 14;

    /// <summary>Columns behind these: a triangle lies between these slopes, counted from the pencil's middle.</summary>
    public const int LowX = 15, HighX = 16, LowY = 17, HighY = 18;

    /// <summary>Most triangles of a leaf.</summary>
    public const int Most = BvhWide.MostItems;

    /// <summary>Triangles that have room in a column.</summary>
    public const int Room = Most * PencilQueue.Most;

    private const double EvaluationDouble = 1.0 / (1 << 20), EvaluationSingle = 1.0 / (1 << 19);
    private const double Rounding = 1.0 / (1 << 20);

    /// <summary>Reads the vertices of a leaf's triangles, those of the last triangle again where there are fewer: relative to the apex, upright, straight on along the pencil's middle.</summary>
    /// <param name="pencil">The rays.</param>
    /// <param name="triangles">The first triangle.</param>
    /// <param name="count">How many, 1 to 4.</param>
    /// <param name="positions">Their vertices.</param>
    /// <param name="vertices">Receives four floats in each of <see cref="VertexNumbers"/> columns.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    [SkipLocalsInit]
    public static void Load<P>(in RayPencil pencil, MeshTriangle* triangles, int count, P positions, float* vertices)
        where P : struct, IMeshPositions
    {
        MeshTriangle* b = triangles + Math.Min(1, count - 1), c = triangles + Math.Min(2, count - 1), d = triangles + (count - 1);
        Load(pencil, positions, triangles->Element0, b->Element0, c->Element0, d->Element0, vertices);
        Load(pencil, positions, triangles->Element1, b->Element1, c->Element1, d->Element1, vertices + (3 * Room));
        Load(pencil, positions, triangles->Element2, b->Element2, c->Element2, d->Element2, vertices + (6 * Room));
    }

    /// <summary>Prepares as many triangles as a vector has lanes.</summary>
    /// <param name="pencil">The rays.</param>
    /// <param name="isSingle">Whether their exact test is in floats.</param>
    /// <param name="count">How many lanes hold a triangle.</param>
    /// <param name="vertices">The first triangle's vertices.</param>
    /// <param name="columns">Its numbers.</param>
    public static void Prepare<F>(in RayPencil pencil, bool isSingle, int count, float* vertices, float* columns)
        where F : unmanaged, IReal<F>
    {
        // Methods of their own, each small enough for the compiler to inline what it calls.
        Bound<F>(pencil, isSingle, vertices, columns);
        uint unknown = SetEdges<F>(pencil, isSingle ? EvaluationSingle : EvaluationDouble, vertices, columns) & ((1u << count) - 1);
        for (; unknown != 0; unknown &= unknown - 1)
        {
            Forget(columns + BitOperations.TrailingZeroCount(unknown));
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Load<P>(in RayPencil pencil, P positions, int a, int b, int c, int d, float* vertices)
        where P : struct, IMeshPositions
    {
        Double4.Turn(positions.Row<Double4>(a), positions.Row<Double4>(b), positions.Row<Double4>(c), positions.Row<Double4>(d), out Double4 first, out Double4 second, out Double4 third);
        (Double4 x, Double4 y, Double4 z) = pencil.Axis == 2 ? (first, second, third) : pencil.Axis == 1 ? (third, first, second) : (second, third, first);
        x -= Double4.Of(pencil.ApexX);
        y -= Double4.Of(pencil.ApexY);
        z = (z - Double4.Of(pencil.ApexZ)) * Double4.Of(pencil.Sign);
        y = Double4.Fma(x, Double4.Of(-pencil.Shear), Double4.Fma(z, Double4.Of(-pencil.MiddleY), y));
        x = Double4.Fma(z, Double4.Of(-pencil.MiddleX), x);
        *(Float4*)vertices = Double4.ToSingle(x);
        *(Float4*)(vertices + Room) = Double4.ToSingle(y);
        *(Float4*)(vertices + (2 * Room)) = Double4.ToSingle(z);
    }

    /// <summary>Between which slopes triangles lie, and the errors of their edge functions but for the evaluation.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Bound<F>(in RayPencil pencil, bool isSingle, float* vertices, float* columns)
        where F : unmanaged, IReal<F>
    {
        F x0 = At<F>(vertices, 0), y0 = At<F>(vertices, 1), z0 = At<F>(vertices, 2);
        F x1 = At<F>(vertices, 3), y1 = At<F>(vertices, 4), z1 = At<F>(vertices, 5);
        F x2 = At<F>(vertices, 6), y2 = At<F>(vertices, 7), z2 = At<F>(vertices, 8);
        F near = F.Min(F.Min(z0, z1), z2), most = F.Max(F.Max(z0, z1), z2), isBefore = F.Less(F.Of(pencil.Nearest), near);
        F toNear = F.Of(1) / near, toFar = F.Of(1) / most, margin = F.Of(pencil.SlopeMargin);
        F leastX = F.Min(F.Min(x0, x1), x2), mostX = F.Max(F.Max(x0, x1), x2), leastY = F.Min(F.Min(y0, y1), y2), mostY = F.Max(F.Max(y0, y1), y2);
        StoreBounds(columns + (LowX * Room), leastX - margin, mostX + margin, toNear, toFar, isBefore);
        StoreBounds(columns + (LowY * Room), leastY - margin, mostY + margin, toNear, toFar, isBefore);
        F unit = F.Of(PencilErrors.Unit), shear = F.Of(Math.Abs(pencil.Shear)), deep = most - near, far = F.Max(most, -near);
        F wide = F.Max(mostX, -leastX) + (far * F.Of(pencil.SpreadX)), high = F.Max(mostY, -leastY) + (far * F.Of(pencil.SpreadY));
        F across = (mostX - leastX) * (F.Of(1) + shear) + (mostY - leastY) + (deep * F.Of((pencil.SpreadX * (1 + Math.Abs(pencil.Shear))) + pencil.SpreadY));
        F own = F.Fma(F.Fma(wide, shear, wide) + high, unit, F.Of(pencil.Size * PencilErrors.Floor)), common = F.Of(pencil.Beside);
        if (isSingle)
        {
            F slope = F.Of(PencilErrors.Unit * (3 + Math.Abs(pencil.Shear)));
            F fromOrigin = F.Max(deep, pencil.Way > 0 ? F.Of(pencil.Way) - near : most);
            common = F.Fma(far, slope, common);
            own += F.Fma(deep, slope, F.Fma(fromOrigin, F.Of(3), across + across) * unit);
        }

        Put(columns, VolumeLow, F.Fma(F.Fma(own, F.Of(2), common), across, own * F.Fma(own, F.Of(14), common * F.Of(4))));
        Put(columns, VolumeHigh, far + across + F.Of(pencil.Way));
        Put(columns, SumError, isBefore);
    }

    /// <summary>Computes and writes edge functions and volumes.</summary>
    /// <returns>Bits of the triangles of which nothing is known.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static uint SetEdges<F>(in RayPencil pencil, double evaluation, float* vertices, float* columns)
        where F : unmanaged, IReal<F>
    {
        F x0 = At<F>(vertices, 0), y0 = At<F>(vertices, 1), z0 = At<F>(vertices, 2);
        F x1 = At<F>(vertices, 3), y1 = At<F>(vertices, 4), z1 = At<F>(vertices, 5);
        F x2 = At<F>(vertices, 6), y2 = At<F>(vertices, 7), z2 = At<F>(vertices, 8);
        F middle0 = Minor(x1, y2 - y1, y1, x2 - x1), middle1 = Minor(x2, y0 - y2, y2, x0 - x2), middle2 = Minor(x0, y1 - y0, y0, x1 - x0);
        F volume = F.Fma(z0, middle0, F.Fma(z1, middle1, z2 * middle2)), sign = volume & F.Of(-0.0);
        F spreadX = F.Of(pencil.SpreadX), spreadY = F.Of(pencil.SpreadY), part = F.Of(evaluation), slack = At<F>(columns, VolumeLow);
        F sumError = AddEdge(x1, y1, z1, x2 - x1, y2 - y1, z2 - z1, middle0, sign, spreadX, spreadY, part, slack, columns);
        sumError += AddEdge(x2, y2, z2, x0 - x2, y0 - y2, z0 - z2, middle1, sign, spreadX, spreadY, part, slack, columns + (EdgeNumbers * Room));
        sumError += AddEdge(x0, y0, z0, x1 - x0, y1 - y0, z1 - z0, middle2, sign, spreadX, spreadY, part, slack, columns + (2 * EdgeNumbers * Room));
        F size = F.Abs(volume), volumeError = sumError * At<F>(columns, VolumeHigh), isBefore = At<F>(columns, SumError);
        Put(columns, SumError, sumError * F.Of(3 * (1 + Rounding)));
        Put(columns, VolumeLow, (size - volumeError) * F.Of(1 - Rounding));
        Put(columns, VolumeHigh, F.Select(isBefore, (size + volumeError) * F.Of(1 + Rounding), F.Of(double.PositiveInfinity)));
        return F.Bits(F.LessOrEqual(size, volumeError));
    }

    /// <summary>Computes and writes one edge function: the scalar product of direction and cross product of two vertices.</summary>
    /// <returns>Its error bound.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F AddEdge<F>(F x, F y, F z, F dx, F dy, F dz, F middle, F sign, F spreadX, F spreadY, F part, F slack, float* columns)
        where F : unmanaged, IReal<F>
    {
        F edgeX = Minor(y, dz, z, dy), edgeY = Minor(z, dx, x, dz);
        x = F.Abs(x);
        y = F.Abs(y);
        z = F.Abs(z);
        F all = F.Fma(F.Abs(dy), F.Fma(spreadX, z, x), F.Fma(F.Abs(dx), F.Fma(spreadY, z, y), F.Abs(dz) * F.Fma(spreadX, y, spreadY * x))), error = F.Fma(all, part, slack);
        Put(columns, EdgeX, edgeX ^ sign);
        Put(columns, EdgeY, edgeY ^ sign);
        Put(columns, EdgeMiddle, (middle ^ sign) + error);
        Put(columns, EdgeError, error + error);
        return error;
    }

    /// <summary>Writes between which slopes triangles lie, with room for roundings.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void StoreBounds<F>(float* columns, F low, F high, F toNear, F toFar, F isBounded)
        where F : unmanaged, IReal<F>
    {
        low = F.Min(low * toNear, low * toFar);
        high = F.Max(high * toNear, high * toFar);
        Put(columns, 0, F.Select(isBounded, F.Fma(F.Abs(low), F.Of(-Rounding), low), F.Of(double.NegativeInfinity)));
        Put(columns, 1, F.Select(isBounded, F.Fma(F.Abs(high), F.Of(Rounding), high), F.Of(double.PositiveInfinity)));
    }

    /// <summary>Writes edge functions that are positive everywhere for a triangle of which nothing is known, so that the exact test decides: which side of them the apex is on is open.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Forget(float* own)
    {
        for (int edge = 0; edge < 3; edge++)
        {
            float* numbers = own + (edge * EdgeNumbers * Room);
            numbers[EdgeX * Room] = numbers[EdgeY * Room] = 0;
            numbers[EdgeMiddle * Room] = numbers[EdgeError * Room];
        }

        own[VolumeLow * Room] = float.NegativeInfinity;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F At<F>(float* columns, int column)
        where F : unmanaged => *(F*)(columns + (column * Room));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Put<F>(float* columns, int column, F numbers)
        where F : unmanaged => *(F*)(columns + (column * Room)) = numbers;

    /// <summary>a d - b c.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Minor<F>(F a, F d, F b, F c)
        where F : unmanaged, IReal<F> => F.Fma(a, d, -(b * c));
}
