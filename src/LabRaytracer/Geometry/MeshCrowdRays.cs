using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Up to 32 rays that go their own ways, in the precision of geometry: the numbers of <see cref="WatertightRay{R}"/> in columns.</summary>
internal unsafe struct MeshCrowdRays
{
    /// <summary>Most rays.</summary>
    public const int Most = BvhCrowd.Most;

    /// <summary>Places of columns.</summary>
    public const int OriginX = 0, OriginY = Most, OriginZ = 2 * Most, ShearX = 3 * Most, ShearY = 4 * Most, ScaleZ = 5 * Most, Limit = 6 * Most, ToFloat = 7 * Most;

    /// <summary>The columns, numbers of the lanes' precision.</summary>
    public fixed double Numbers[8 * Most];

    /// <summary>The axis that becomes x.</summary>
    public fixed int Turn[Most];

    /// <summary>Adds prepared rays.</summary>
    /// <param name="ray">The rays.</param>
    /// <param name="boxRay">The same, prepared for boxes.</param>
    /// <param name="place">Place of the first one, a multiple of their number.</param>
    public void Add<R, F, I>(in RayLanes<R> ray, in BvhRay<R, F, I> boxRay, int place)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        WatertightRay<R> prepared = new(ray);
        fixed (MeshCrowdRays* self = &this)
        {
            byte* numbers = (byte*)self->Numbers + ((long)place * sizeof(R) / R.Width);
            Put(numbers, OriginX, prepared.OriginX);
            Put(numbers, OriginY, prepared.OriginY);
            Put(numbers, OriginZ, prepared.OriginZ);
            Put(numbers, ShearX, prepared.ShearX);
            Put(numbers, ShearY, prepared.ShearY);
            Put(numbers, ScaleZ, prepared.ScaleZ);
            Put(numbers, Limit, boxRay.Limit);
            Put(numbers, ToFloat, boxRay.ToFloat);
            I alongX = R.MaskToInt32(prepared.AlongX), alongY = R.MaskToInt32(prepared.AlongY);
            *(I*)(self->Turn + place) = (alongX & I.Of(1)) | (alongY & I.Of(2));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static void Put(byte* numbers, int column, R value) => *(R*)(numbers + (column * (sizeof(R) / R.Width))) = value;
    }
}
