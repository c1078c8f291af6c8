using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Parts of a pencil, each a group of lanes: which of them may meet a box, and which of its triangles, many at once.</summary>
/// <remarks>
/// <para>A part's slopes are a rectangle. A box is tested as by <see cref="PencilBoxes"/>, with the same margin and roundings, in lanes that are parts: for both planes along z, as slopes of parts differ in sign.</para>
/// <para>An edge function is largest in one of the rectangle's corners. Lanes are pairs, triangle k mod 4 with part k / 4. The rectangle around the triangle is tested, too: beside its
/// acute corners, a triangle the size of a part's pixels has much room where no edge function alone is negative.</para>
/// <para>What is found is below the true largest value by at most 10 u times what an edge function adds up (<see cref="PencilTriangles"/>): three roundings of the coefficients and one of
/// what raises them, of middle and differences, and four more. Edge functions are raised by at least 16 u times that, beside the slack of the exact test.</para>
/// </remarks>
/// <typeparam name="F">Float lanes, at least four.</typeparam>
/// <typeparam name="I">Integer lanes of the same width.</typeparam>
internal readonly unsafe struct PencilParts<F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <summary>Most parts of a pencil.</summary>
    public const int Most = MeshPencil.MostPackets;

    /// <summary>Bytes that the numbers of all parts take.</summary>
    public const int Bytes = sizeof(float) * Most * (Columns + (PairNumbers * PencilTriangles.Most));

    private const int Across = 3 * BvhWideNode.Width;

    // Columns of a number each part: the planes along least and largest slopes, as factor of z and limit, then how far the part looks.
    private const int LowX = 0, HighX = 2, LowY = 4, HighY = 6, Far = 8, Columns = 9;

    // Behind the columns, vectors for each group of pairs: the middle of the slopes along x, along y, and their largest differences from it; then least and largest x, and y.
    private const int PairNumbers = 8;

    private readonly float* _numbers;
    private readonly F _shear, _sign, _nearest;
    private readonly int _atX, _atY, _atZ, _atNear;

    /// <param name="pencil">The pencil.</param>
    /// <param name="tree">Where the tree is.</param>
    /// <param name="slopes">The slopes of each part.</param>
    /// <param name="count">How many parts.</param>
    /// <param name="numbers">Room for <see cref="Bytes"/> bytes.</param>
    public PencilParts(in RayPencil pencil, in BvhFrame tree, SlopeBounds* slopes, int count, float* numbers)
    {
        _numbers = numbers;
        int axisX = (pencil.Axis + 1) % 3, axisY = (pencil.Axis + 2) % 3;
        (_atX, _atY, _atZ) = (axisX * BvhWideNode.Width, axisY * BvhWideNode.Width, pencil.Axis * BvhWideNode.Width);
        _atNear = pencil.Sign > 0 ? _atZ : _atZ + Across;
        double margin = PencilBoxes.Margin(pencil);
        double x = pencil.ApexX - tree.Center(axisX), y = pencil.ApexY - tree.Center(axisY) - (pencil.Shear * x), z = pencil.ApexZ - tree.Center(pencil.Axis);
        _shear = F.Of(-pencil.Shear);
        _sign = F.Of(pencil.Sign);
        _nearest = F.Of(-(pencil.Sign * z) - margin);
        for (int part = 0; part < Most; part++)
        {
            SetFar(part, -1);
            if (part < count && !slopes[part].IsEmpty)
            {
                SetPlane(part, LowX, pencil.Sign * (slopes[part].LowX - pencil.SlopeError), x, z, -margin);
                SetPlane(part, HighX, pencil.Sign * (slopes[part].HighX + pencil.SlopeError), x, z, margin);
                SetPlane(part, LowY, pencil.Sign * (slopes[part].LowY - pencil.SlopeError), y, z, -margin);
                SetPlane(part, HighY, pencil.Sign * (slopes[part].HighY + pencil.SlopeError), y, z, margin);
                SetPairs(part, slopes[part], pencil);
            }
        }
    }

    /// <summary>No part looks farther along z.</summary>
    public float LargestFar
    {
        get
        {
            F largest = At(Far, 0);
            for (int vector = 1; vector < Most / F.Width; vector++)
            {
                largest = F.Max(largest, At(Far, vector));
            }

            return (float)F.Largest(largest);
        }
    }

    /// <summary>Sets how far a part looks along z; below 0 for nowhere.</summary>
    public void SetFar(int part, float far) => _numbers[(Far * Most) + part] = far;

    /// <summary>Bits of the parts that may meet a box.</summary>
    /// <param name="box">Its smallest x in the planes of its parent (<see cref="BvhWideNode"/>).</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public uint Meet(float* box)
    {
        F leastX = Plane(box, _atX), mostX = Plane(box, _atX + Across), leastY = Plane(box, _atY), mostY = Plane(box, _atY + Across);
        F leastZ = Plane(box, _atZ), mostZ = Plane(box, _atZ + Across), near = F.Max(F.Fma(Plane(box, _atNear), _sign, _nearest), F.Zero);
        leastY = F.Min(F.Fma(leastX, _shear, leastY), F.Fma(mostX, _shear, leastY));
        mostY = F.Max(F.Fma(leastX, _shear, mostY), F.Fma(mostX, _shear, mostY));
        uint met = 0;
        for (int vector = 0; vector < Most / F.Width; vector++)
        {
            F lowX = At(LowX, vector), highX = At(HighX, vector), lowY = At(LowY, vector), highY = At(HighY, vector);
            F inside = F.LessOrEqual(At(LowX + 1, vector), F.Max(F.Fma(leastZ, lowX, mostX), F.Fma(mostZ, lowX, mostX)))
                & F.LessOrEqual(F.Min(F.Fma(leastZ, highX, leastX), F.Fma(mostZ, highX, leastX)), At(HighX + 1, vector))
                & F.LessOrEqual(At(LowY + 1, vector), F.Max(F.Fma(leastZ, lowY, mostY), F.Fma(mostZ, lowY, mostY)))
                & F.LessOrEqual(F.Min(F.Fma(leastZ, highY, leastY), F.Fma(mostZ, highY, leastY)), At(HighY + 1, vector))
                & F.LessOrEqual(near, At(Far, vector));
            met |= F.Bits(inside) << (vector * F.Width);
        }

        return met;
    }

    /// <summary>Finds the pairs of waiting triangles and parts that may hit each other, as many as a vector has lanes at a time.</summary>
    /// <param name="queue">The leaves; receives the pairs.</param>
    /// <param name="columns">Their triangles, prepared.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void FindPairs(PencilQueue* queue, float* columns)
    {
        int together = F.Width / PencilTriangles.Most, groups = 0, pairs = 0;
        ulong parts = queue->Parts;
        for (ulong rest = FirstOfGroups(parts, together); rest != 0; rest &= rest - 1)
        {
            int at = BitOperations.TrailingZeroCount(rest), leaf = (int)((uint)at / Most), first = (int)((uint)at % Most);
            uint own = (uint)(parts >> at) & ((1u << together) - 1), triangles = (1u << queue->Count[leaf]) - 1;
            uint bits = Pairs(columns + (PencilTriangles.Most * leaf), first) & (FirstOfFour(own) * triangles);
            queue->Bits[groups] = bits;
            queue->From[groups] = PencilQueue.Of(leaf, first);
            groups += bits != 0 ? 1 : 0;
            pairs += BitOperations.PopCount(bits);
        }

        queue->Bits[groups] = 0;
        queue->Groups = groups;
        queue->Pairs = pairs;
    }

    /// <summary>Bits of the pairs of some parts, as many as a vector has room for, that may hit each other.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private uint Pairs(float* columns, int first)
    {
        const int Next = PencilTriangles.EdgeNumbers * PencilTriangles.Room, Room = PencilTriangles.Room;
        F* part = (F*)(_numbers + (Most * Columns) + (first * PairNumbers * PencilTriangles.Most));
        F x = part[0], y = part[1], spreadX = part[2], spreadY = part[3];
        F largest = F.Min(F.Min(Largest(x, y, spreadX, spreadY, columns), Largest(x, y, spreadX, spreadY, columns + Next)), Largest(x, y, spreadX, spreadY, columns + (2 * Next)));
        float* bounds = columns + (PencilTriangles.LowX * Room);
        F overlaps = F.LessOrEqual(LaneFours.Repeat<F>(bounds), part[5]) & F.LessOrEqual(part[4], LaneFours.Repeat<F>(bounds + Room))
            & F.LessOrEqual(LaneFours.Repeat<F>(bounds + (2 * Room)), part[7]) & F.LessOrEqual(part[6], LaneFours.Repeat<F>(bounds + (3 * Room)));
        return F.Bits(F.LessOrEqual(F.Zero, largest) & overlaps);
    }

    /// <summary>In each group of bits, the lowest, set if any is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ulong FirstOfGroups(ulong bits, int together) =>
        together == 1 ? bits : together == 2 ? (bits | (bits >> 1)) & 0x5555555555555555 : (bits | (bits >> 1) | (bits >> 2) | (bits >> 3)) & 0x1111111111111111;

    /// <summary>Four bits, each followed by three that are 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint FirstOfFour(uint bits) => (bits | (bits << 3) | (bits << 6) | (bits << 9)) & 0x1111;

    /// <summary>The largest value of an edge function in each part.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Largest(F x, F y, F spreadX, F spreadY, float* edge)
    {
        F edgeX = LaneFours.Repeat<F>(edge + (PencilTriangles.EdgeX * PencilTriangles.Room)), edgeY = LaneFours.Repeat<F>(edge + (PencilTriangles.EdgeY * PencilTriangles.Room));
        F inMiddle = F.Fma(x, edgeX, F.Fma(y, edgeY, LaneFours.Repeat<F>(edge + (PencilTriangles.EdgeMiddle * PencilTriangles.Room))));
        return F.Fma(spreadX, F.Abs(edgeX), F.Fma(spreadY, F.Abs(edgeY), inMiddle));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Plane(float* box, int place) => F.Broadcast((F*)box, place);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private F At(int column, int vector) => ((F*)(_numbers + (column * Most)))[vector];

    /// <summary>The plane x = slope z, moved by a margin.</summary>
    private void SetPlane(int part, int column, double slope, double x, double z, double margin)
    {
        _numbers[(column * Most) + part] = (float)-slope;
        _numbers[((column + 1) * Most) + part] = (float)(x - (slope * z) + margin);
    }

    /// <summary>A part's rectangle, counted from the pencil's middle, next to each of four triangles.</summary>
    private void SetPairs(int part, in SlopeBounds slopes, in RayPencil pencil)
    {
        int first = PencilTriangles.Most * part;
        float* to = _numbers + (Most * Columns) + (PairNumbers * (first / F.Width * F.Width)) + (first % F.Width);
        *(Float4*)to = Float4.Of(slopes.MiddleX - pencil.MiddleX);
        *(Float4*)(to + F.Width) = Float4.Of(slopes.MiddleY - pencil.MiddleY);
        *(Float4*)(to + (2 * F.Width)) = Float4.Of(slopes.SpreadX + pencil.SlopeError);
        *(Float4*)(to + (3 * F.Width)) = Float4.Of(slopes.SpreadY + pencil.SlopeError);
        *(Float4*)(to + (4 * F.Width)) = Float4.Of(slopes.LowX - pencil.MiddleX - pencil.SlopeError);
        *(Float4*)(to + (5 * F.Width)) = Float4.Of(slopes.HighX - pencil.MiddleX + pencil.SlopeError);
        *(Float4*)(to + (6 * F.Width)) = Float4.Of(slopes.LowY - pencil.MiddleY - pencil.SlopeError);
        *(Float4*)(to + (7 * F.Width)) = Float4.Of(slopes.HighY - pencil.MiddleY + pencil.SlopeError);
    }
}
