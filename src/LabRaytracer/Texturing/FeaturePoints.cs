using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Distances to the nearest of random points, one in each cell of the unit lattice.</summary>
/// <remarks>
/// S. Worley, "A cellular texture basis function", SIGGRAPH 1996, with one point a cell. The search goes outward ring by ring until no cell can hold a nearer point: the
/// result is exact, where a fixed block of 3 x 3 x 3 cells would cut distances off. What is skipped cannot change a result, so lanes do not depend on their neighbours.
/// </remarks>
internal static class FeaturePoints
{
    /// <summary>More rings than any metric needs: the second nearest point is at most 3 away.</summary>
    private const int MostRings = 4;

    /// <summary>Smallest and second smallest distance.</summary>
    /// <param name="point">Points, in cells.</param>
    /// <param name="key">Key of the layer.</param>
    /// <param name="metric">How distance is measured.</param>
    /// <param name="first">Smallest distance.</param>
    /// <param name="second">Second smallest distance.</param>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static void Nearest<R, F, I>(in PatternPoint<R, F> point, int key, WorleyMetric metric, out F first, out F second)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        Search<F, I> search = new() { Key = key, Metric = metric, IsFlat = point.IsFlat, First = F.Of(1e30), Second = F.Of(1e30) };
        search.CellX = Lattice.Cell<R, F, I>(point.X, out search.X);
        search.CellY = Lattice.Cell<R, F, I>(point.Y, out search.Y);
        search.CellZ = Lattice.Cell<R, F, I>(point.Z, out search.Z);
        for (int ring = 0; ring <= MostRings && search.MayImprove(ring); ring++)
        {
            search.Look(ring);
        }

        first = metric == WorleyMetric.Euclidean ? F.Sqrt(search.First) : search.First;
        second = metric == WorleyMetric.Euclidean ? F.Sqrt(search.Second) : search.Second;
    }

    /// <summary>A search around points. Euclidean distances are squared until the end.</summary>
    private struct Search<F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        public int Key;
        public WorleyMetric Metric;
        public bool IsFlat;
        public I CellX, CellY, CellZ;
        public F X, Y, Z;
        public F First, Second;

        /// <summary>Tells whether a cell of a ring can hold a point that counts for any lane.</summary>
        public readonly bool MayImprove(int ring)
        {
            if (ring == 0)
            {
                return true;
            }

            F edge = F.Min(F.Min(Gap(ring, X), Gap(-ring, X)), F.Min(Gap(ring, Y), Gap(-ring, Y)));
            edge = IsFlat ? edge : F.Min(edge, F.Min(Gap(ring, Z), Gap(-ring, Z)));
            return F.Any(F.Less(Metric == WorleyMetric.Euclidean ? edge * edge : edge, Second));
        }

        /// <summary>Looks into the cells of a ring.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        public void Look(int ring)
        {
            int depth = IsFlat ? 0 : ring;
            for (int z = -depth; z <= depth; z++)
            {
                for (int y = -ring; y <= ring; y++)
                {
                    bool isSide = Math.Abs(z) == ring || Math.Abs(y) == ring;
                    for (int x = -ring; x <= ring; x += isSide || ring == 0 ? 1 : 2 * ring)
                    {
                        if (F.Any(F.Less(Distance(Gap(x, X), Gap(y, Y), Gap(z, Z)), Second)))
                        {
                            Visit(x, y, z);
                        }
                    }
                }
            }
        }

        /// <summary>Takes the point of one cell into account.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        private void Visit(int x, int y, int z)
        {
            I bits = CellHash.Of(CellHash.Column(Lattice.Next(CellX, x), Key), CellHash.Step(Lattice.Next(CellY, y), Lattice.Next(CellZ, z)));
            F distance = Distance(Away(bits, 22, x, X), Away(bits, 12, y, Y), Away(bits, 2, z, Z));
            Second = F.Min(Second, F.Max(First, distance));
            First = F.Min(First, distance);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private readonly F Distance(F x, F y, F z)
        {
            z = IsFlat ? F.Zero : z;
            return Metric switch
            {
                WorleyMetric.Euclidean => F.Fma(x, x, F.Fma(y, y, z * z)),
                WorleyMetric.Manhattan => x + (y + z),
                _ => F.Max(x, F.Max(y, z)),
            };
        }

        /// <summary>Distance along one axis to the point of a cell, which is ten bits of its hash.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static F Away(I bits, int shift, int step, F inside)
        {
            F place = F.Fma(F.FromInt32(I.ShiftRight(bits, shift) & I.Of(1023)), F.Of(1.0 / 1024), F.Of(step));
            return F.Abs(place - inside);
        }

        /// <summary>Distance along one axis to the nearest face of a cell: rounded as <see cref="Away"/> is, so never more than that.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static F Gap(int step, F inside) => step switch
        {
            > 0 => F.Of(step) - inside,
            < 0 => inside - F.Of(step + 1),
            _ => F.Zero,
        };
    }
}
