using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A pencil of rays against eight boxes at a time: the four planes around it, and the nearest and farthest z of interest.</summary>
/// <remarks>
/// A box lies outside of a plane through the apex, x = s z or y - k x = s z with the pencil's shear k, if its corner that is farthest inside does; which one that is depends
/// on the signs of s and k alone. Floats here are rounded by less than 2^-21 of the pencil's size, four times that is the margin, and how far beside a line the triangle test sees points.
/// </remarks>
internal readonly unsafe struct PencilBoxes : IBvhWideTest
{
    private const double Rounding = 1.0 / (1 << 19);
    private const int Across = 3 * BvhWideNode.Width;
    private readonly Float8 _lowX, _highX, _lowY, _highY, _shear;
    private readonly Float8 _lowXLimit, _highXLimit, _lowYLimit, _highYLimit;
    private readonly Float8 _sign, _nearest, _farthest;
    private readonly int _atX, _atY, _atLowX, _atHighX, _atLowY, _atHighY, _atLowShear, _atHighShear, _atNear, _atFar;

    /// <param name="pencil">The rays, measured.</param>
    /// <param name="tree">Where the tree is.</param>
    public PencilBoxes(in RayPencil pencil, in BvhFrame tree)
    {
        int axisX = (pencil.Axis + 1) % 3, axisY = (pencil.Axis + 2) % 3, z = pencil.Axis * BvhWideNode.Width;
        double margin = Margin(pencil);
        double x = pencil.ApexX - tree.Center(axisX), y = pencil.ApexY - tree.Center(axisY) - (pencil.Shear * x), apexZ = pencil.ApexZ - tree.Center(pencil.Axis);
        (_atX, _atY) = (axisX * BvhWideNode.Width, axisY * BvhWideNode.Width);
        SetPlane(pencil.Sign * (pencil.MiddleX - pencil.SpreadX), x, apexZ, -margin, z, z + Across, out _lowX, out _lowXLimit, out _atLowX);
        SetPlane(pencil.Sign * (pencil.MiddleX + pencil.SpreadX), x, apexZ, margin, z + Across, z, out _highX, out _highXLimit, out _atHighX);
        SetPlane(pencil.Sign * (pencil.MiddleY - pencil.SpreadY), y, apexZ, -margin, z, z + Across, out _lowY, out _lowYLimit, out _atLowY);
        SetPlane(pencil.Sign * (pencil.MiddleY + pencil.SpreadY), y, apexZ, margin, z + Across, z, out _highY, out _highYLimit, out _atHighY);
        _shear = Float8.Of(-pencil.Shear);
        (_atLowShear, _atHighShear) = pencil.Shear > 0 ? (_atX, _atX + Across) : (_atX + Across, _atX);
        _sign = Float8.Of(pencil.Sign);
        _nearest = Float8.Of(-(pencil.Sign * apexZ) - margin);
        _farthest = Float8.Of(-(pencil.Sign * apexZ) + margin);
        (_atNear, _atFar) = pencil.Sign > 0 ? (z, z + Across) : (z + Across, z);
    }

    /// <summary>By how much boxes are larger than what is in them.</summary>
    public static double Margin(in RayPencil pencil) => (pencil.Size * Rounding) + (pencil.TestError * (1 + Math.Abs(pencil.Shear)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint Meet(float* planes, float limit, out Float8 near)
    {
        near = Float8.Max(Float8.Fma(At(planes, _atNear), _sign, _nearest), Float8.Zero);
        Float8 far = Float8.Fma(At(planes, _atFar), _sign, _farthest);
        Float8 lowY = Float8.Fma(At(planes, _atLowShear), _shear, At(planes, _atY + Across)), highY = Float8.Fma(At(planes, _atHighShear), _shear, At(planes, _atY));
        Float8 inside = Float8.LessOrEqual(_lowXLimit, Float8.Fma(At(planes, _atLowX), _lowX, At(planes, _atX + Across)))
            & Float8.LessOrEqual(Float8.Fma(At(planes, _atHighX), _highX, At(planes, _atX)), _highXLimit)
            & Float8.LessOrEqual(_lowYLimit, Float8.Fma(At(planes, _atLowY), _lowY, lowY))
            & Float8.LessOrEqual(Float8.Fma(At(planes, _atHighY), _highY, highY), _highYLimit);
        return Float8.Bits(inside & Float8.LessOrEqual(near, Float8.Min(far, Float8.Of(limit))));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Float8 At(float* planes, int place) => *(Float8*)(planes + place);

    /// <summary>The plane x = slope z, moved by a margin.</summary>
    private static void SetPlane(double slope, double x, double z, double margin, int ifUp, int ifDown, out Float8 toZ, out Float8 limit, out int at)
    {
        toZ = Float8.Of(-slope);
        limit = Float8.Of(x - (slope * z) + margin);
        at = slope > 0 ? ifUp : ifDown;
    }
}
