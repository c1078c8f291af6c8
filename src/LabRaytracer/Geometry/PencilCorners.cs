using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Vertices of four triangles, relative to the apex of a pencil and with its axes, and for float lanes the errors of their edge functions (<see cref="PencilErrors"/>).</summary>
internal unsafe struct PencilCorners
{
    /// <summary>Coordinates of vertices 0, 1 and 2.</summary>
    public Double4 X0, Y0, Z0, X1, Y1, Z1, X2, Y2, Z2;

    /// <summary>Error of any edge function.</summary>
    public Double4 Error;

    /// <summary>No vertex is farther from apex and origins along z, plus how long edges look.</summary>
    public Double4 Reach;

    /// <summary>Reads vertices, those of the last triangle again where there are fewer, and bounds the errors.</summary>
    /// <param name="pencil">The pencil.</param>
    /// <param name="triangles">The first triangle.</param>
    /// <param name="count">How many, 1 to 4.</param>
    /// <param name="positions">Their vertices.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public void Load<P>(in RayPencil pencil, MeshTriangle* triangles, int count, P positions)
        where P : struct, IMeshPositions
    {
        Load(pencil, triangles, count, positions, out Double4 x0, out Double4 y0, out Double4 z0, out Double4 x1, out Double4 y1, out Double4 z1, out Double4 x2, out Double4 y2, out Double4 z2);
        (X0, Y0, Z0, X1, Y1, Z1, X2, Y2, Z2) = (x0, y0, z0, x1, y1, z1, x2, y2, z2);
        Double4 least = Double4.Min(Double4.Min(z0, z1), z2), largest = Double4.Max(Double4.Max(z0, z1), z2), deep = largest - least, far = Double4.Max(largest, -least);
        Double4 across = Double4.Max(Double4.Max(Across(pencil, x1 - x0, y1 - y0, z1 - z0), Across(pencil, x2 - x1, y2 - y1, z2 - z1)), Across(pencil, x0 - x2, y0 - y2, z0 - z2));
        Double4 fromOrigin = Double4.Max(deep, pencil.Way > 0 ? Double4.Of(pencil.Way) - least : largest), slope = Double4.Of(PencilErrors.Unit * (3 + Math.Abs(pencil.Shear)));
        Double4 common = Double4.Fma(far, slope, Double4.Of(pencil.Beside));
        Double4 own = Double4.Fma(deep, slope, Double4.Fma(Double4.Fma(fromOrigin, Double4.Of(3), across + across), Double4.Of(PencilErrors.Unit), Double4.Of(pencil.Size * PencilErrors.Floor)));
        Error = Double4.Fma(Double4.Fma(own, Double4.Of(2), common), across, own * Double4.Fma(own, Double4.Of(14), common * Double4.Of(4)));
        Reach = far + across + Double4.Of(pencil.Way);
    }

    /// <summary>Reads the vertices of four triangles.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Load<P>(
        in RayPencil pencil, MeshTriangle* triangles, int count, P positions,
        out Double4 x0, out Double4 y0, out Double4 z0, out Double4 x1, out Double4 y1, out Double4 z1, out Double4 x2, out Double4 y2, out Double4 z2)
        where P : struct, IMeshPositions
    {
        MeshTriangle* b = triangles + Math.Min(1, count - 1), c = triangles + Math.Min(2, count - 1), d = triangles + (count - 1);
        Vertices(pencil, positions, triangles->Element0, b->Element0, c->Element0, d->Element0, out x0, out y0, out z0);
        Vertices(pencil, positions, triangles->Element1, b->Element1, c->Element1, d->Element1, out x1, out y1, out z1);
        Vertices(pencil, positions, triangles->Element2, b->Element2, c->Element2, d->Element2, out x2, out y2, out z2);
    }

    /// <summary>A vertex of each of four triangles, relative to the apex.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Vertices<P>(in RayPencil pencil, P positions, int a, int b, int c, int d, out Double4 x, out Double4 y, out Double4 z)
        where P : struct, IMeshPositions
    {
        Double4.Turn(positions.Row<Double4>(a), positions.Row<Double4>(b), positions.Row<Double4>(c), positions.Row<Double4>(d), out Double4 first, out Double4 second, out Double4 third);
        (x, y, z) = pencil.Axis == 2 ? (first, second, third) : pencil.Axis == 1 ? (third, first, second) : (second, third, first);
        x -= Double4.Of(pencil.ApexX);
        y -= Double4.Of(pencil.ApexY);
        z = (z - Double4.Of(pencil.ApexZ)) * Double4.Of(pencil.Sign);
    }

    /// <summary>How long edges look to any ray of the pencil, at most, as the sum of x and y.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Double4 Across(in RayPencil pencil, Double4 x, Double4 y, Double4 z)
    {
        double middleY = pencil.MiddleY + (pencil.Shear * pencil.MiddleX), spread = ((1 + Math.Abs(pencil.Shear)) * pencil.SpreadX) + pencil.SpreadY;
        return Double4.Abs(Double4.Fma(z, Double4.Of(-pencil.MiddleX), x)) + Double4.Fma(Double4.Abs(z), Double4.Of(spread), Double4.Abs(Double4.Fma(z, Double4.Of(-middleY), y)));
    }
}
