using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Looks up a transformed texture, many points at a time.</summary>
internal sealed unsafe class TransformedSampler(TransformedTexture texture, TextureSampler source, bool movesPoints, bool movesCoordinates) : TextureSampler
{
    protected override IReadOnlyList<TextureSampler> Sources => [source];

    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        const int chunk = TextureParts.Chunk;
        R* memory = stackalloc R[8 * chunk];
        F* steps = stackalloc F[10 * chunk];
        for (int start = 0; start < packets; start += chunk)
        {
            int count = Math.Min(chunk, packets - start);
            LookupBatch<R> part = lookups.Part(start, count);
            if (movesCoordinates)
            {
                MoveCoordinates(ref part, memory, steps, count);
            }

            if (movesPoints)
            {
                MovePoints(ref part, memory + (2 * chunk), count);
                MoveSteps(ref part, steps + (4 * chunk), count);
            }

            source.Sample<R, F, I>(part, new ColorColumns<F> { R = colors.R + start, G = colors.G + start, B = colors.B + start }, count);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void MoveCoordinates<R, F>(ref LookupBatch<R> part, R* memory, F* steps, int count)
        where R : unmanaged, IReal<R>
        where F : unmanaged, IReal<F>
    {
        CoordinateBatch<R> moved = new() { U = memory, V = memory + TextureParts.Chunk };
        for (int i = 0; i < count; i++)
        {
            (moved.U[i], moved.V[i]) = texture.Uv.Apply(part.Coordinates.U[i], part.Coordinates.V[i]);
        }

        part.Coordinates = moved;
        FootprintColumns from = part.Footprints;
        if (from.DuDx != null)
        {
            FootprintColumns to = new((float*)steps, TextureParts.Chunk * F.Width);
            for (int i = 0; i < count; i++)
            {
                (((F*)to.DuDx)[i], ((F*)to.DvDx)[i]) = texture.Uv.ApplyToStep(((F*)from.DuDx)[i], ((F*)from.DvDx)[i]);
                (((F*)to.DuDy)[i], ((F*)to.DvDy)[i]) = texture.Uv.ApplyToStep(((F*)from.DuDy)[i], ((F*)from.DvDy)[i]);
            }

            part.Footprints = to;
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void MovePoints<R>(ref LookupBatch<R> part, R* memory, int count)
        where R : unmanaged, IReal<R>
    {
        const int chunk = TextureParts.Chunk;
        bool isWorld = texture.Frame == TextureFrame.World;
        PositionBatch<R> from = part.Positions, to = part.Positions;
        to.X = memory;
        to.Y = memory + chunk;
        to.Z = memory + (2 * chunk);
        to.NormalX = memory + (3 * chunk);
        to.NormalY = memory + (4 * chunk);
        to.NormalZ = memory + (5 * chunk);
        ReadOnlySpan<double> inverse = texture.Transform.ObjectFromWorldRows, rows = texture.Transform.WorldFromObjectRows;
        for (int i = 0; i < count; i++)
        {
            (R x, R y, R z) = isWorld ? (from.WorldX[i], from.WorldY[i], from.WorldZ[i]) : (from.X[i], from.Y[i], from.Z[i]);
            Affine.Point(inverse, ref x, ref y, ref z);
            (to.X[i], to.Y[i], to.Z[i]) = (x, y, z);
            (x, y, z) = isWorld ? (from.WorldNormalX[i], from.WorldNormalY[i], from.WorldNormalZ[i]) : (from.NormalX[i], from.NormalY[i], from.NormalZ[i]);
            Affine.Normal(rows, ref x, ref y, ref z);
            (to.NormalX[i], to.NormalY[i], to.NormalZ[i]) = (x, y, z);
        }

        part.Positions = to;
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void MoveSteps<R, F>(ref LookupBatch<R> part, F* memory, int count)
        where R : unmanaged, IReal<R>
        where F : unmanaged, IReal<F>
    {
        LocalFootprintColumns from = texture.Frame == TextureFrame.World ? part.WorldFootprints : part.LocalFootprints;
        part.LocalFootprints = default;
        if (from.XDx == null)
        {
            return;
        }

        LocalFootprintColumns to = new((float*)memory, TextureParts.Chunk * F.Width);
        ReadOnlySpan<double> inverse = texture.Transform.ObjectFromWorldRows;
        for (int i = 0; i < count; i++)
        {
            F x = ((F*)from.XDx)[i], y = ((F*)from.YDx)[i], z = ((F*)from.ZDx)[i];
            Affine.Step(inverse, ref x, ref y, ref z);
            (((F*)to.XDx)[i], ((F*)to.YDx)[i], ((F*)to.ZDx)[i]) = (x, y, z);
            (x, y, z) = (((F*)from.XDy)[i], ((F*)from.YDy)[i], ((F*)from.ZDy)[i]);
            Affine.Step(inverse, ref x, ref y, ref z);
            (((F*)to.XDy)[i], ((F*)to.YDy)[i], ((F*)to.ZDy)[i]) = (x, y, z);
        }

        part.LocalFootprints = to;
    }
}
