namespace LabRaytracer.Validation;

/// <summary>A ray against a shape in exact arithmetic.</summary>
/// <param name="IsHit">True if there is a hit with t above 0.</param>
/// <param name="T">Ray parameter of the first one.</param>
/// <param name="X">Local x: the point in the shape's unit form.</param>
/// <param name="Y">Local y.</param>
/// <param name="Z">Local z.</param>
/// <param name="Gap">How far the decision is from changing, relative to the shape's size.</param>
internal readonly record struct ExactHit(bool IsHit, Real T, Real X, Real Y, Real Z, double Gap)
{
    /// <summary>The truth about a ray and one of the library's shapes; all numbers of both count as exact.</summary>
    public static ExactHit Of(Shape shape, in Ray ray) => shape switch
    {
        Sphere sphere => OfSphere(sphere, new Line(ray, sphere.Center)),
        Cylinder cylinder => OfCylinder(cylinder, new Line(ray, cylinder.Center)),
        InfinitePlane plane => OfPlane(plane, new Line(ray, plane.Point)),
        Disk disk => OfDisk(disk, new Line(ray, disk.Center)),
        Quad quad => OfQuad(quad, new Line(ray, quad.Corner)),
        Box box => OfBox(box, ray),
        _ => throw new ArgumentException($"There is no exact form of {shape.GetType().Name}.", nameof(shape)),
    };

    private static ExactHit Miss(double gap) => new(false, 0, 0, 0, 0, gap);

    private static ExactHit OfSphere(Sphere sphere, in Line line)
    {
        Real square = (Real)sphere.Radius * sphere.Radius;
        Real a = Dot(line.Direction, line.Direction), b = Dot(line.Origin, line.Direction), outside = Dot(line.Origin, line.Origin) - square;
        Real discriminant = (b * b) - (a * outside);
        double gap = Math.Abs((discriminant / (a * square)).ToDouble());
        if (discriminant.Sign < 0)
        {
            return Miss(gap);
        }

        // Where the ray starts matters only if the sphere is not behind.
        Real root = Real.Sqrt(Real.Short(discriminant, 500));
        gap = b.Sign > 0 ? Math.Abs((outside / square).ToDouble()) : Math.Min(gap, Math.Abs((outside / square).ToDouble()));
        Real near = Root(b, root, outside, a, -1), far = Root(b, root, outside, a, 1);
        Real t = near.Sign > 0 ? near : far;
        return t.Sign > 0 ? At(line, t, 1 / (Real)sphere.Radius, gap) : Miss(gap);
    }

    private static ExactHit OfCylinder(Cylinder cylinder, in Line line)
    {
        Real square = (Real)cylinder.Radius * cylinder.Radius, half = Real.Scale(cylinder.Height, -1);
        (Real x, Real y, Real z) = line.Origin;
        (Real dx, Real dy, Real dz) = line.Direction;
        Real a = (dx * dx) + (dz * dz), b = (x * dx) + (z * dz), outside = (x * x) + (z * z) - square;
        Real discriminant = (b * b) - (a * outside);
        if (a.Sign == 0 || discriminant.Sign < 0)
        {
            return Miss(a.Sign == 0 ? 1 : Math.Abs((discriminant / (a * square)).ToDouble()));
        }

        double gap = Math.Min(Math.Abs((discriminant / (a * square)).ToDouble()), Math.Abs((outside / square).ToDouble()));
        Real root = Real.Sqrt(Real.Short(discriminant, 500));
        foreach (Real t in new[] { Root(b, root, outside, a, -1), Root(b, root, outside, a, 1) })
        {
            Real height = y + (t * dy);
            gap = Math.Min(gap, Math.Abs(((Real.Abs(height) / half) - 1).ToDouble()));
            if (t.Sign > 0 && Real.Abs(height) <= half)
            {
                Real scale = 1 / (Real)cylinder.Radius;
                return new ExactHit(true, t, (x + (t * dx)) * scale, height / half, (z + (t * dz)) * scale, gap);
            }
        }

        return Miss(gap);
    }

    private static ExactHit OfPlane(InfinitePlane plane, in Line line)
    {
        Real approach = Dot(plane.Normal, line.Direction);
        if (approach.Sign == 0)
        {
            return Miss(1);
        }

        Real t = -Dot(plane.Normal, line.Origin) / approach;
        return t.Sign > 0 ? At(line, t, 1, 1) : Miss(1);
    }

    private static ExactHit OfDisk(Disk disk, in Line line)
    {
        ExactHit hit = Flat(line, disk.Normal, out bool isParallel);
        if (isParallel)
        {
            return Miss(1);
        }

        Real scale = 1 / (Real)disk.Radius;
        (Real X, Real Y, Real Z) p = (hit.X * scale, hit.Y * scale, hit.Z * scale);
        Real reach = Real.Sqrt(Real.Short(Dot(p, p)));
        double gap = Math.Abs((reach - 1).ToDouble());
        return hit.T.Sign > 0 && reach <= 1 ? new ExactHit(true, hit.T, Dot(disk.LocalX, p), 0, Dot(disk.LocalZ, p), gap) : Miss(gap);
    }

    private static ExactHit OfQuad(Quad quad, in Line line)
    {
        (Real, Real, Real) v = Of(quad.EdgeV), u = Of(quad.EdgeU), normal = Cross(u, v);
        ExactHit hit = Flat(line, normal, out bool isParallel);
        if (isParallel)
        {
            return Miss(1);
        }

        (Real, Real, Real) p = (hit.X, hit.Y, hit.Z), dualV = Cross(normal, u), dualU = Cross(v, normal);
        Real x = (2 * Dot(p, dualV) / Dot(v, dualV)) - 1, z = (2 * Dot(p, dualU) / Dot(u, dualU)) - 1;
        Real reach = Real.Abs(x) > Real.Abs(z) ? Real.Abs(x) : Real.Abs(z);
        double gap = Math.Abs((reach - 1).ToDouble());
        return hit.T.Sign > 0 && reach <= 1 ? new ExactHit(true, hit.T, x, 0, z, gap) : Miss(gap);
    }

    private static ExactHit OfBox(Box box, in Ray ray)
    {
        Real[] low = [box.Min.X, box.Min.Y, box.Min.Z], high = [box.Max.X, box.Max.Y, box.Max.Z];
        Real[] o = [ray.Origin.X, ray.Origin.Y, ray.Origin.Z], d = [ray.Direction.X, ray.Direction.Y, ray.Direction.Z];
        Real? near = null, far = null;
        Real size = 0, length = Real.Sqrt(Real.Short(Dot(Of(ray.Direction), Of(ray.Direction))));
        for (int k = 0; k < 3; k++)
        {
            size = high[k] - low[k] > size ? high[k] - low[k] : size;
            if (d[k].Sign == 0)
            {
                if (o[k] < low[k] || o[k] > high[k])
                {
                    return Miss(1);
                }

                continue;
            }

            Real first = ((d[k].Sign > 0 ? low[k] : high[k]) - o[k]) / d[k], last = ((d[k].Sign > 0 ? high[k] : low[k]) - o[k]) / d[k];
            near = near is { } n && n > first ? n : first;
            far = far is { } f && f < last ? f : last;
        }

        Real unit = length / size;
        double gap = Math.Min(Math.Abs(((far!.Value - near!.Value) * unit).ToDouble()), Math.Min(Math.Abs((near.Value * unit).ToDouble()), Math.Abs((far.Value * unit).ToDouble())));
        Real t = near.Value.Sign > 0 ? near.Value : far.Value;
        if (near.Value > far.Value || t.Sign <= 0)
        {
            return Miss(gap);
        }

        Real Local(int k) => (((2 * (o[k] + (t * d[k]))) - low[k] - high[k]) / (high[k] - low[k]));
        return new ExactHit(true, t, Local(0), Local(1), Local(2), gap);
    }

    /// <summary>The larger part of a root of a t² + 2 b t + c = 0 without cancellation; the other from the product of both.</summary>
    private static Real Root(Real b, Real root, Real c, Real a, int sign)
    {
        Real q = b.Sign > 0 ? -b - root : -b + root;
        bool isLarge = b.Sign > 0 == sign < 0;
        return isLarge || q.Sign == 0 ? q / a : c / q;
    }

    /// <summary>Where a ray meets a plane through the line's origin of coordinates, relative to it.</summary>
    private static ExactHit Flat(in Line line, (Real, Real, Real) normal, out bool isParallel)
    {
        Real approach = Dot(normal, line.Direction);
        isParallel = approach.Sign == 0;
        return isParallel ? Miss(1) : At(line, -Dot(normal, line.Origin) / approach, 1, 1);
    }

    private static ExactHit Flat(in Line line, Vector3D normal, out bool isParallel) => Flat(line, Of(normal), out isParallel);

    private static ExactHit At(in Line line, Real t, Real scale, double gap) => new(
        true, t, (line.Origin.X + (t * line.Direction.X)) * scale, (line.Origin.Y + (t * line.Direction.Y)) * scale, (line.Origin.Z + (t * line.Direction.Z)) * scale, gap);

    private static (Real X, Real Y, Real Z) Of(Vector3D v) => (v.X, v.Y, v.Z);

    private static Real Dot(Vector3D a, (Real X, Real Y, Real Z) b) => Dot(Of(a), b);

    private static Real Dot((Real X, Real Y, Real Z) a, (Real X, Real Y, Real Z) b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);

    private static (Real X, Real Y, Real Z) Cross((Real X, Real Y, Real Z) a, (Real X, Real Y, Real Z) b) =>
        ((a.Y * b.Z) - (a.Z * b.Y), (a.Z * b.X) - (a.X * b.Z), (a.X * b.Y) - (a.Y * b.X));

    /// <summary>A ray whose origin is relative to a point, exactly.</summary>
    private readonly struct Line(in Ray ray, Point3D from)
    {
        public readonly (Real X, Real Y, Real Z) Origin = (ray.Origin.X - (Real)from.X, ray.Origin.Y - (Real)from.Y, ray.Origin.Z - (Real)from.Z);

        public readonly (Real X, Real Y, Real Z) Direction = Of(ray.Direction);
    }
}
