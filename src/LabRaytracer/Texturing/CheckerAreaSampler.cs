using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>A checker's means over footprints, many points at a time.</summary>
internal sealed unsafe class CheckerAreaSampler(CheckerTexture checker) : TextureSampler
{
    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        for (int packet = 0; packet < packets; packet++)
        {
            R gap = R.Of(1);
            R mean = checker.Space == CheckerSpace.Uv ? InTexture<R, F, I>(lookups, packet, out gap) : InObject<R, F, I>(lookups, packet);
            F share = R.ToSingle(gap), wave = R.ToSingle(mean);
            colors.R[packet] = Mix(share, wave, checker.Even.R, checker.Odd.R, checker.Line.R);
            colors.G[packet] = Mix(share, wave, checker.Even.G, checker.Odd.G, checker.Line.G);
            colors.B[packet] = Mix(share, wave, checker.Even.B, checker.Odd.B, checker.Line.B);
        }
    }

    /// <summary>The mean over one footprint.</summary>
    public static Intensity Sample(CheckerTexture checker, in TextureLookup lookup)
    {
        Double1 gap = new(1), mean;
        if (checker.Space == CheckerSpace.Uv)
        {
            TextureFootprint footprint = lookup.Footprint;
            CheckerSides<Double1> sides = Sides(checker, Point<Double1>(footprint.DuDx, footprint.DvDx, 0), Point<Double1>(footprint.DuDy, footprint.DvDy, 0));
            mean = CheckerArea.Mean(new Double1(lookup.Coordinate.U * checker.Columns), new Double1(lookup.Coordinate.V * checker.Rows), sides, checker.LineWidth / 2, out gap);
        }
        else
        {
            (Vector3D x, Vector3D y) = (lookup.LocalFootprint.DpDx, lookup.LocalFootprint.DpDy);
            mean = InObject(
                checker,
                Point<Double1>(lookup.LocalPoint.X, lookup.LocalPoint.Y, lookup.LocalPoint.Z),
                Point<Double1>(lookup.LocalNormal.X, lookup.LocalNormal.Y, lookup.LocalNormal.Z),
                Sides(checker, Point<Double1>(x.X, x.Y, x.Z), Point<Double1>(y.X, y.Y, y.Z)));
        }

        Float1 share = new((float)gap.Value), wave = new((float)mean.Value);
        return new Intensity(
            Mix(share, wave, checker.Even.R, checker.Odd.R, checker.Line.R).Value,
            Mix(share, wave, checker.Even.G, checker.Odd.G, checker.Line.G).Value,
            Mix(share, wave, checker.Even.B, checker.Odd.B, checker.Line.B).Value);
    }

    private R InTexture<R, F, I>(in LookupBatch<R> lookups, int packet, out R gap)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        CheckerPoint<R> x = new() { U = Load<R, F, I>(lookups.Footprints.DuDx, packet), V = Load<R, F, I>(lookups.Footprints.DvDx, packet) };
        CheckerPoint<R> y = new() { U = Load<R, F, I>(lookups.Footprints.DuDy, packet), V = Load<R, F, I>(lookups.Footprints.DvDy, packet) };
        R u = lookups.Coordinates.U[packet] * R.Of(checker.Columns), v = lookups.Coordinates.V[packet] * R.Of(checker.Rows);
        return CheckerArea.Mean(u, v, Sides(checker, x, y), checker.LineWidth / 2, out gap);
    }

    private R InObject<R, F, I>(in LookupBatch<R> lookups, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I>
    {
        LocalFootprintColumns steps = lookups.LocalFootprints;
        CheckerPoint<R> x = new() { U = Load<R, F, I>(steps.XDx, packet), V = Load<R, F, I>(steps.YDx, packet), W = Load<R, F, I>(steps.ZDx, packet) };
        CheckerPoint<R> y = new() { U = Load<R, F, I>(steps.XDy, packet), V = Load<R, F, I>(steps.YDy, packet), W = Load<R, F, I>(steps.ZDy, packet) };
        PositionBatch<R> at = lookups.Positions;
        return InObject(
            checker,
            new CheckerPoint<R> { U = at.X[packet], V = at.Y[packet], W = at.Z[packet] },
            new CheckerPoint<R> { U = at.NormalX[packet], V = at.NormalY[packet], W = at.NormalZ[packet] },
            Sides(checker, x, y));
    }

    /// <summary>The mean of the cubes; an axis along which the footprint is flat takes the cell that the surface belongs to.</summary>
    private static R InObject<R>(CheckerTexture checker, in CheckerPoint<R> at, in CheckerPoint<R> normal, in CheckerSides<R> sides)
        where R : unmanaged, IReal<R>
    {
        CheckerPoint<R> point = new()
        {
            U = SquareWave.Sign(CheckerTexture.Cell(at.U, checker.Columns, normal.U)),
            V = SquareWave.Sign(CheckerTexture.Cell(at.V, checker.Rows, normal.V)),
            W = SquareWave.Sign(CheckerTexture.Cell(at.W, checker.Columns, normal.W)),
        };
        return CheckerArea.Mean(Scale(checker, at), point, sides);
    }

    private static CheckerSides<R> Sides<R>(CheckerTexture checker, in CheckerPoint<R> x, in CheckerPoint<R> y)
        where R : unmanaged, IReal<R> => new(Scale(checker, x), Scale(checker, y));

    private static CheckerPoint<R> Scale<R>(CheckerTexture checker, in CheckerPoint<R> point)
        where R : unmanaged, IReal<R>
    {
        R columns = R.Of(checker.Columns);
        return new CheckerPoint<R> { U = point.U * columns, V = point.V * R.Of(checker.Rows), W = point.W * columns };
    }

    private static CheckerPoint<R> Point<R>(double u, double v, double w)
        where R : unmanaged, IReal<R> => new() { U = R.Of(u), V = R.Of(v), W = R.Of(w) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static R Load<R, F, I>(float* column, int packet)
        where R : unmanaged, ILane<R, F, I>
        where F : unmanaged, ILane<F, F, I>
        where I : unmanaged, IIndexLane<I> => column == null ? R.Zero : R.FromSingle(((F*)column)[packet]);

    /// <summary>Cells and lines by their shares.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static F Mix<F>(F gap, F wave, float even, float odd, float line)
        where F : unmanaged, IReal<F>
    {
        float middle = (even + odd) / 2;
        return F.Fma(wave, F.Of((even - odd) / 2), F.Fma(gap, F.Of(middle - line), F.Of(line)));
    }
}
