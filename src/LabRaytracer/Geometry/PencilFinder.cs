using System.Numerics;
using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Finds out whether some groups of lanes are a pencil of rays.</summary>
internal static unsafe class PencilFinder
{
    /// <summary>Tells whether rays are a pencil, and which.</summary>
    /// <param name="lanes">Groups of lanes with their rays and limits; their slopes are set.</param>
    /// <param name="count">How many groups.</param>
    /// <param name="mesh">Where the mesh is.</param>
    /// <param name="endsAtApex">Whether rays end in the apex, at their limits, instead of starting there.</param>
    /// <param name="parts">Receives the bounds of the slopes of each group of lanes.</param>
    /// <param name="pencil">Receives apex, axis, slopes and error bounds.</param>
    public static bool Find<R, F, I>(PencilLanes<R, F, I>* lanes, int count, in BvhFrame mesh, bool endsAtApex, SlopeBounds* parts, out RayPencil pencil)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        pencil = default;
        int active = 0, first = -1, lane = 0;
        for (int packet = 0; packet < count; packet++)
        {
            uint bits = R.Bits(R.Less(R.Zero, lanes[packet].Limit));
            (first, lane) = first < 0 && bits != 0 ? (packet, BitOperations.TrailingZeroCount(bits)) : (first, lane);
            active += BitOperations.PopCount(bits);
        }

        if (active < MeshPencil.FewestRays)
        {
            return false;
        }

        pencil.Rays = active;
        Point3D apex = EndOf(lanes + first, lane, endsAtApex);
        Vector3D direction = new(Take(lanes[first].Ray.DirectionX, lane), Take(lanes[first].Ray.DirectionY, lane), Take(lanes[first].Ray.DirectionZ, lane));
        pencil.Axis = LargestAxis(direction);
        Turn(pencil.Axis, apex, direction, out pencil.ApexX, out pencil.ApexY, out pencil.ApexZ, out double z);
        pencil.Sign = z < 0 == endsAtApex ? 1 : -1;
        double deviation = 0, limit = 0;
        for (int packet = 0; packet < count; packet++)
        {
            if (!Belongs(lanes + packet, pencil.Axis, z < 0 ? -1 : 1, apex, endsAtApex, ref deviation, ref limit))
            {
                return false;
            }
        }

        if (!PencilErrors.SetSize<R>(ref pencil, apex, mesh, deviation, limit))
        {
            return false;
        }

        Measure(lanes, count, endsAtApex, parts, ref pencil);
        return true;
    }

    /// <summary>Where a ray starts, or where it ends, in the precision of lanes.</summary>
    private static Point3D EndOf<R, F, I>(PencilLanes<R, F, I>* lanes, int lane, bool endsAtApex)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Point3D origin = new(Take(lanes->Ray.OriginX, lane), Take(lanes->Ray.OriginY, lane), Take(lanes->Ray.OriginZ, lane));
        if (endsAtApex)
        {
            origin += Take(lanes->Limit, lane) * new Vector3D(Take(lanes->Ray.DirectionX, lane), Take(lanes->Ray.DirectionY, lane), Take(lanes->Ray.DirectionZ, lane));
        }

        return R.IsSingle ? new((float)origin.X, (float)origin.Y, (float)origin.Z) : origin;
    }

    private static double Take<R>(R lanes, int lane)
        where R : unmanaged, IReal<R> => Lane.Take(&lanes, lane);

    private static int LargestAxis(Vector3D direction)
    {
        double x = Math.Abs(direction.X), y = Math.Abs(direction.Y), z = Math.Abs(direction.Z);
        return x > y && x > z ? 0 : y > z ? 1 : 2;
    }

    /// <summary>Tells whether all rays of a group that are on belong to the pencil: they are largest along its axis, go the same way along it, and share the apex.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static bool Belongs<R, F, I>(PencilLanes<R, F, I>* lanes, int axis, int sign, Point3D apex, bool endsAtApex, ref double deviation, ref double limit)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        RayLanes<R>* ray = &lanes->Ray;
        R isOff = R.LessOrEqual(lanes->Limit, R.Zero);
        R x = R.Abs(ray->DirectionX), y = R.Abs(ray->DirectionY), z = R.Abs(ray->DirectionZ), along = (&ray->DirectionX)[axis] * R.Of(sign);
        R isAlong = R.LessOrEqual(x, along) & R.LessOrEqual(y, along) & R.LessOrEqual(z, along) & R.Less(R.Of(PencilErrors.LeastPace), along) & R.Less(along, R.Of(1 / PencilErrors.LeastPace));
        isAlong &= WatertightRay<R>.IsAlong(axis, x, y, z);
        if (!R.All(isOff | isAlong))
        {
            return false;
        }

        if (!endsAtApex)
        {
            return R.All(isOff | (R.Equal(ray->OriginX, R.Of(apex.X)) & R.Equal(ray->OriginY, R.Of(apex.Y)) & R.Equal(ray->OriginZ, R.Of(apex.Z))));
        }

        R beside = R.Abs(R.Fma(lanes->Limit, ray->DirectionX, ray->OriginX) - R.Of(apex.X))
            + R.Abs(R.Fma(lanes->Limit, ray->DirectionY, ray->OriginY) - R.Of(apex.Y))
            + R.Abs(R.Fma(lanes->Limit, ray->DirectionZ, ray->OriginZ) - R.Of(apex.Z));
        deviation = Math.Max(deviation, R.Largest(beside & ~isOff));
        limit = Math.Max(limit, R.Largest(lanes->Limit * along & ~isOff));
        return double.IsFinite(deviation + limit);
    }

    private static void Turn(int axis, Point3D apex, Vector3D direction, out double x, out double y, out double z, out double along) =>
        (x, y, z, along) = axis == 2 ? (apex.X, apex.Y, apex.Z, direction.Z)
            : axis == 1 ? (apex.Z, apex.X, apex.Y, direction.Y)
            : (apex.Y, apex.Z, apex.X, direction.X);

    /// <summary>Slopes of the rays, their middle and spread. Those of a camera are upright already, those of a lamp are not.</summary>
    private static void Measure<R, F, I>(PencilLanes<R, F, I>* lanes, int count, bool isSheared, SlopeBounds* parts, ref RayPencil pencil)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        SlopeSums<R> sums = default;
        for (int packet = 0; packet < count; packet++)
        {
            SetSlopes(lanes + packet, pencil);
            if (isSheared)
            {
                sums.Add(lanes[packet].FullX, lanes[packet].FullY, R.Less(R.Zero, lanes[packet].Limit));
            }
        }

        pencil.Shear = isSheared ? (float)sums.Shear : 0;
        SlopeBounds all = SlopeBounds.None;
        for (int packet = 0; packet < count; packet++)
        {
            Bound(lanes + packet, pencil.Shear, out parts[packet]);
            all.Include(parts[packet]);
        }

        (pencil.MiddleX, pencil.MiddleY) = ((float)all.MiddleX, (float)all.MiddleY);
        pencil.SlopeMargin = pencil.TestError * (1 + Math.Abs(pencil.Shear));
        pencil.SlopeError = 1.2e-7 * (1 + Math.Abs(pencil.Shear));
        (pencil.SpreadX, pencil.SpreadY) = (all.SpreadX + pencil.SlopeError, all.SpreadY + pencil.SlopeError);
        for (int packet = 0; packet < count; packet++)
        {
            PencilLanes<R, F, I>* own = lanes + packet;
            F isOn = R.MaskToSingle(R.Less(R.Zero, own->Limit));
            own->SlopeX = R.ToSingle(own->FullX - R.Of(pencil.MiddleX)) & isOn;
            own->SlopeY = R.ToSingle(own->FullY - R.Of(pencil.MiddleY)) & isOn;
        }
    }

    /// <summary>Slopes of a group of lanes, and their pace.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void SetSlopes<R, F, I>(PencilLanes<R, F, I>* lanes, in RayPencil pencil)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        R* direction = &lanes->Ray.DirectionX;
        R z = direction[pencil.Axis], inverse = R.Of(pencil.Sign) / z;
        lanes->Pace = R.Abs(z);
        lanes->FullX = direction[(pencil.Axis + 1) % 3] * inverse;
        lanes->FullY = direction[(pencil.Axis + 2) % 3] * inverse;
    }

    /// <summary>Shears the slopes of a group of lanes and bounds them.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static void Bound<R, F, I>(PencilLanes<R, F, I>* lanes, double shear, out SlopeBounds bounds)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        lanes->FullY = R.Fma(R.Of(-shear), lanes->FullX, lanes->FullY);
        F isOn = R.MaskToSingle(R.Less(R.Zero, lanes->Limit)), slopeX = R.ToSingle(lanes->FullX), slopeY = R.ToSingle(lanes->FullY), least = F.Of(-SlopeBounds.Above);
        bounds.HighX = (float)F.Largest(F.Select(isOn, slopeX, least));
        bounds.HighY = (float)F.Largest(F.Select(isOn, slopeY, least));
        bounds.LowX = -(float)F.Largest(F.Select(isOn, -slopeX, least));
        bounds.LowY = -(float)F.Largest(F.Select(isOn, -slopeY, least));
    }
}
