using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The first hit of an upright cone, seen from its apex, and how certain it is.</summary>
/// <typeparam name="R">Lane type of geometry.</typeparam>
/// <remarks>
/// With k = radius / height the side is x² + z² = k² y², -height &lt;= y &lt;= 0: a s² + 2 b s + c = 0 along l + s d with a = d∘d, b = l∘d, c = l∘l under the product
/// u∘v = ux vx + uz vz - k² uy vy. The discriminant b² - a c is k² ((lx dy - ly dx)² + (lz dy - ly dz)²) - (lx dz - lz dx)², where each difference is right to the last digits.
/// One root is q / a, the other c / q, so that rays along the side (a near 0) keep the one that matters.
/// </remarks>
internal readonly struct ConeChoice<R>
    where R : unmanaged, IReal<R>
{
    /// <summary>Mask of hits.</summary>
    public readonly R IsHit;

    /// <summary>Mask of hits of the base.</summary>
    public readonly R IsBase;

    /// <summary>Mask: the decision is too close to be certain.</summary>
    public readonly R IsClose;

    /// <summary>Mask: the error shows in t or in the point; or the decision was close.</summary>
    public readonly R IsRough;

    /// <summary>Steps from the nearest point to the hit.</summary>
    public readonly R Along;

    /// <param name="ray">Rays from their points nearest to the apex.</param>
    /// <param name="radius">Radius of the base.</param>
    /// <param name="height">Height.</param>
    /// <param name="hasBase">1 for a base, 0 for none.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public ConeChoice(in CentredRay<R> ray, in R radius, in R height, in R hasBase)
    {
        R dx = ray.DirectionX, dy = ray.DirectionY, dz = ray.DirectionZ;
        R k = radius / height, steep = k * dy, tall = k * ray.Y;
        R a = R.Fma(dx, dx, R.Fma(dz, dz, -(steep * steep)));
        R b = R.Fma(ray.X, dx, R.Fma(ray.Z, dz, -(tall * steep)));
        R c = R.Fma(ray.X, ray.X, R.Fma(ray.Z, ray.Z, -(tall * tall)));
        R first = k * Compensated.DifferenceOfProducts(ray.X, dy, ray.Y, dx), second = k * Compensated.DifferenceOfProducts(ray.Z, dy, ray.Y, dz);
        R third = Compensated.DifferenceOfProducts(ray.X, dz, ray.Z, dx);
        R sides = R.Fma(first, first, second * second), across = third * third;
        R discriminant = sides - across, terms = sides + across;
        R root = R.Sqrt(R.Max(discriminant, R.Zero));
        R q = -(b + R.Select(R.Less(b, R.Zero), -root, root));
        R isReal = R.LessOrEqual(R.Zero, discriminant);
        R byA = q / a, byQ = c / q;
        R magnitude = R.Fma(ray.X, ray.X, R.Fma(ray.Z, ray.Z, tall * tall));

        // Errors of the roots in units of the last place: of the square root's argument, and of c, which cancels.
        R wobble = terms / root;
        R errorA = R.Abs(byA) + (wobble / R.Abs(a)), errorQ = R.Abs(byQ) + ((magnitude + (R.Abs(byQ) * wobble)) / R.Abs(q));
        Candidate candidateA = new(ray, byA, errorA, height, R.Zero), candidateQ = new(ray, byQ, errorQ, height, R.Zero);
        R floor = (-height - ray.Y) / dy;
        Candidate candidateBase = Candidate.OfBase(ray, floor, (height + R.Abs(ray.Y)) / R.Abs(dy), radius);
        R isClosed = R.Less(R.Zero, hasBase);

        R along = R.Of(double.PositiveInfinity), error = R.Zero, isBase = R.Zero;
        Take(candidateA.IsHit & isReal, byA, errorA, R.Zero, ref along, ref error, ref isBase);
        Take(candidateQ.IsHit & isReal, byQ, errorQ, R.Zero, ref along, ref error, ref isBase);
        Take(candidateBase.IsHit & isClosed, floor, candidateBase.Error, R.True, ref along, ref error, ref isBase);
        IsHit = R.Less(along, R.Of(double.PositiveInfinity));
        IsBase = isBase;
        Along = along;
        R unit = R.Of(R.IsSingle ? 16.0 / (1 << 24) : 16.0 / (1L << 53));
        IsClose = R.LessOrEqual(R.Abs(discriminant), unit * terms) | (isReal & (candidateA.IsClose | candidateQ.IsClose)) | (isClosed & candidateBase.IsClose);
        R least = R.Min(R.Of(0.5) * R.Abs(ray.K + along), R.Of(8) * R.Min(radius, height) * R.Sqrt(ray.InverseLengthSquared));
        IsRough = ~R.LessOrEqual(error, least) | IsClose;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Take(R mask, R place, R placeError, R isOnBase, ref R along, ref R error, ref R isBase)
    {
        R nearer = mask & R.Less(place, along);
        along = R.Select(nearer, place, along);
        error = R.Select(nearer, placeError, error);
        isBase = R.Select(nearer, isOnBase, isBase);
    }

    /// <summary>One place where a ray may hit.</summary>
    private readonly struct Candidate
    {
        /// <summary>Mask: it lies ahead, on the cone.</summary>
        public readonly R IsHit;

        /// <summary>Mask: that is too close to be certain.</summary>
        public readonly R IsClose;

        /// <summary>Error in units of the last place.</summary>
        public readonly R Error;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public Candidate(in CentredRay<R> ray, R along, R error, R height, R top)
        {
            R unit = R.Of(R.IsSingle ? 16.0 / (1 << 24) : 16.0 / (1L << 53));
            R y = R.Fma(along, ray.DirectionY, ray.Y);
            R slack = unit * R.Fma(error, R.Abs(ray.DirectionY), height + R.Abs(ray.Y));
            R isAhead = IsAhead(ray, along, error, unit, out R startIsClose);
            Error = error;
            IsHit = isAhead & R.LessOrEqual(-height, y) & R.LessOrEqual(y, top);
            IsClose = startIsClose | R.LessOrEqual(R.Abs(y - top), slack) | R.LessOrEqual(R.Abs(y + height), slack);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private Candidate(R isHit, R isClose, R error) => (IsHit, IsClose, Error) = (isHit, isClose, error);

        /// <summary>The place where the plane of the base is.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Candidate OfBase(in CentredRay<R> ray, R along, R error, R radius)
        {
            R unit = R.Of(R.IsSingle ? 16.0 / (1 << 24) : 16.0 / (1L << 53));
            R x = R.Fma(along, ray.DirectionX, ray.X), z = R.Fma(along, ray.DirectionZ, ray.Z);
            R distance = R.Sqrt(R.Fma(x, x, z * z));
            R speed = R.Abs(ray.DirectionX) + R.Abs(ray.DirectionZ);
            R slack = unit * R.Fma(error, speed, radius + R.Abs(ray.X) + R.Abs(ray.Z));
            R isAhead = IsAhead(ray, along, error, unit, out R startIsClose);
            return new Candidate(isAhead & R.LessOrEqual(distance, radius), startIsClose | R.LessOrEqual(R.Abs(distance - radius), slack), error);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static R IsAhead(in CentredRay<R> ray, R along, R error, R unit, out R isClose)
        {
            R t = ray.K + along;
            isClose = R.LessOrEqual(R.Abs(t), unit * (R.Abs(ray.K) + error));
            return R.Less(R.Zero, t) & R.Less(t, R.Of(double.PositiveInfinity));
        }
    }
}
