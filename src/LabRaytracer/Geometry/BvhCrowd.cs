using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Up to 32 rays that go their own ways, each against the eight boxes of a node, which is read once for all of them.</summary>
/// <remarks>Columns of the numbers of <see cref="BvhRay{R, F, I}"/>; a ray is known by its place in them, and sets of rays by bits.</remarks>
internal unsafe struct BvhCrowd
{
    /// <summary>Most rays.</summary>
    public const int Most = 32;

    private const int Axis = BvhWideNode.Width, Across = 3 * Axis;

    // Numbers of the columns, in the order of the fields below.
    private const int Inverse = 0, Early = 3, Late = 6, Limit = 9, First = 10, Last = 13, Bit = 16;
    private fixed float _inverseX[Most], _inverseY[Most], _inverseZ[Most];
    private fixed float _earlyX[Most], _earlyY[Most], _earlyZ[Most];
    private fixed float _lateX[Most], _lateY[Most], _lateZ[Most];
    private fixed float _limit[Most];

    // How many bytes the planes that are met first, and those that are met last, lie behind the smallest coordinates of a node.
    private fixed uint _firstX[Most], _firstY[Most], _firstZ[Most];
    private fixed uint _lastX[Most], _lastY[Most], _lastZ[Most];
    private fixed int _bit[Most];

    /// <summary>Bits of the rays that go on.</summary>
    public uint Active;

    /// <summary>Where the search is: the node or leaf that comes next.</summary>
    public int At;

    /// <summary>Bits of the rays that meet it.</summary>
    public uint Here;

    /// <summary>How many nodes and leaves are put aside.</summary>
    public int Depth;

    /// <summary>Whether the items of the leaf that comes next have been asked for.</summary>
    public bool IsExpected;

    /// <summary>Starts without rays.</summary>
    public void Clear() => Active = 0;

    /// <summary>Adds prepared rays.</summary>
    /// <param name="rays">The rays.</param>
    /// <param name="place">Place of the first one, a multiple of their number.</param>
    public void Add<R, F, I>(in BvhRay<R, F, I> rays, int place)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        fixed (BvhCrowd* self = &this)
        {
            Set(self->_inverseX + place, self->_earlyX + place, self->_lateX + place, (int*)self->_firstX + place, (int*)self->_lastX + place, rays.X);
            Set(self->_inverseY + place, self->_earlyY + place, self->_lateY + place, (int*)self->_firstY + place, (int*)self->_lastY + place, rays.Y);
            Set(self->_inverseZ + place, self->_earlyZ + place, self->_lateZ + place, (int*)self->_firstZ + place, (int*)self->_lastZ + place, rays.Z);
            *(F*)(self->_limit + place) = BvhRay<R, F, I>.LimitOf(rays.Limit, rays.ToFloat);
            for (int lane = place; lane < place + R.Width; lane++)
            {
                self->_bit[lane] = 1 << lane;
            }
        }

        Active |= rays.Active << place;

        static void Set(float* inverse, float* early, float* late, int* first, int* last, in BvhSlab<F> slab)
        {
            *(F*)inverse = slab.Inverse;
            *(F*)early = slab.Near;
            *(F*)late = slab.Far;
            I isNegative = F.MaskToInt32(F.Less(slab.Inverse, F.Zero)), across = I.Of(Across * sizeof(float));
            *(I*)first = isNegative & across;
            *(I*)last = ~isNegative & across;
        }
    }

    /// <summary>Lowers the limit of a ray; below 0, the ray ends.</summary>
    public void Lower(int place, float limit)
    {
        _limit[place] = limit;
        Active = limit < 0 ? Active & ~(1u << place) : Active;
    }

    /// <summary>Rays against the boxes of a node.</summary>
    /// <param name="crowd">All rays.</param>
    /// <param name="node">The node.</param>
    /// <param name="rays">Bits of the rays that take part.</param>
    /// <param name="near">The least of where they enter each box, also of those that pass it by: good for an order, and for nothing else.</param>
    /// <returns>Bits of the rays that may meet each box before their limits.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Int8 Meet(BvhCrowd* crowd, BvhWideNode* node, uint rays, out Float8 near)
    {
        Int8 who = Int8.Of(0);
        near = Float8.Of(float.PositiveInfinity);
        do
        {
            float* ray = (float*)crowd + BitOperations.TrailingZeroCount(rays);
            rays &= rays - 1;
            Float8 inverseX = Number(ray, Inverse), inverseY = Number(ray, Inverse + 1), inverseZ = Number(ray, Inverse + 2);
            Float8 nearX = Float8.Fma(Planes(node, ray, First, 0), inverseX, Number(ray, Early));
            Float8 nearY = Float8.Fma(Planes(node, ray, First + 1, Axis), inverseY, Number(ray, Early + 1));
            Float8 nearZ = Float8.Fma(Planes(node, ray, First + 2, 2 * Axis), inverseZ, Number(ray, Early + 2));
            Float8 farX = Float8.Fma(Planes(node, ray, Last, 0), inverseX, Number(ray, Late));
            Float8 farY = Float8.Fma(Planes(node, ray, Last + 1, Axis), inverseY, Number(ray, Late + 1));
            Float8 farZ = Float8.Fma(Planes(node, ray, Last + 2, 2 * Axis), inverseZ, Number(ray, Late + 2));
            Float8 enters = Float8.Max(Float8.Max(nearX, nearY), Float8.Max(nearZ, Float8.Zero));
            Float8 leaves = Float8.Min(Float8.Min(farX, farY), Float8.Min(farZ, Number(ray, Limit)));
            who |= Float8.MaskToInt32(Float8.LessOrEqual(enters, leaves)) & Int8.Of(*(int*)(ray + (Bit * Most)));
            near = Float8.Min(near, enters);
        }
        while (rays != 0);

        return who;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Float8 Number(float* ray, int column) => Float8.Of(ray[column * Most]);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Float8 Planes(BvhWideNode* node, float* ray, int column, int axis) => *(Float8*)((byte*)node + *(uint*)(ray + (column * Most)) + (axis * sizeof(float)));
}
