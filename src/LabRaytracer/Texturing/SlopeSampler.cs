using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Slopes of a texture of heights by differences to both sides, for textures that are no picture.</summary>
/// <remarks>Red, green (and blue) are the derivatives by u and v, or by x, y and z.</remarks>
/// <param name="heights">The texture made ready, as data.</param>
/// <param name="channel">Which channel is the height.</param>
/// <param name="space">What they are derivatives by.</param>
internal sealed unsafe class SlopeSampler(TextureSampler heights, TextureChannel channel, SlopeSpace space) : TextureSampler
{
    protected override IReadOnlyList<TextureSampler> Sources => [heights];

    /// <summary>The step to either side, texture, local or scene units: fine enough for a thousand details, coarse enough for heights in float.</summary>
    public const double Step = 1.0 / 2048;

    /// <summary>What the slopes of a texture are derivatives by: (u, v) if it reads them.</summary>
    public static SlopeSpace SpaceOf(ITexture texture) =>
        (texture.Needs & TextureNeeds.Coordinate) != 0 ? SlopeSpace.Texture
        : (texture.Needs & TextureNeeds.WorldPoint) != 0 ? SlopeSpace.World
        : SlopeSpace.Local;

    [SkipLocalsInit]
    public override void Sample<R, F, I>(in LookupBatch<R> lookups, in ColorColumns<F> colors, int packets)
    {
        R* moved = stackalloc R[packets];
        F* memory = stackalloc F[6 * packets];
        ColorColumns<F> ahead = new() { R = memory, G = memory + packets, B = memory + (2 * packets) };
        ColorColumns<F> behind = new() { R = memory + (3 * packets), G = memory + (4 * packets), B = memory + (5 * packets) };
        F* zero = colors.B;
        new Span<F>(zero, packets).Clear();
        for (int axis = 0; axis < (space == SlopeSpace.Texture ? 2 : 3); axis++)
        {
            LookupBatch<R> shifted = Along(lookups, axis, moved, out R* from);
            Move(from, moved, Step, packets);
            heights.Sample<R, F, I>(shifted, ahead, packets);
            Move(from, moved, -Step, packets);
            heights.Sample<R, F, I>(shifted, behind, packets);
            Divide(ahead, behind, axis == 0 ? colors.R : axis == 1 ? colors.G : colors.B, packets);
        }
    }

    /// <summary>Lookups that read one coordinate from another column.</summary>
    private LookupBatch<R> Along<R>(in LookupBatch<R> lookups, int axis, R* moved, out R* from)
        where R : unmanaged, IReal<R>
    {
        LookupBatch<R> shifted = lookups;
        if (space == SlopeSpace.World)
        {
            PositionBatch<R> positions = lookups.Positions;
            from = axis == 0 ? positions.WorldX : axis == 1 ? positions.WorldY : positions.WorldZ;
            positions.WorldX = axis == 0 ? moved : positions.WorldX;
            positions.WorldY = axis == 1 ? moved : positions.WorldY;
            positions.WorldZ = axis == 2 ? moved : positions.WorldZ;
            shifted.Positions = positions;
        }
        else if (space == SlopeSpace.Local)
        {
            PositionBatch<R> positions = lookups.Positions;
            from = axis == 0 ? positions.X : axis == 1 ? positions.Y : positions.Z;
            positions.X = axis == 0 ? moved : positions.X;
            positions.Y = axis == 1 ? moved : positions.Y;
            positions.Z = axis == 2 ? moved : positions.Z;
            shifted.Positions = positions;
        }
        else
        {
            CoordinateBatch<R> coordinates = lookups.Coordinates;
            from = axis == 0 ? coordinates.U : coordinates.V;
            shifted.Coordinates = new CoordinateBatch<R> { U = axis == 0 ? moved : coordinates.U, V = axis == 1 ? moved : coordinates.V };
        }

        return shifted;
    }

    private static void Move<R>(R* from, R* to, double step, int packets)
        where R : unmanaged, IReal<R>
    {
        for (int packet = 0; packet < packets; packet++)
        {
            to[packet] = from[packet] + R.Of(step);
        }
    }

    /// <summary>Differences first: neighbouring floats are subtracted exactly, and a luminance of differences adds no rounding of the heights' size.</summary>
    private void Divide<F>(in ColorColumns<F> ahead, in ColorColumns<F> behind, F* slope, int packets)
        where F : unmanaged, IReal<F>
    {
        F inverse = F.Of(0.5 / Step);
        for (int packet = 0; packet < packets; packet++)
        {
            slope[packet] = inverse * channel switch
            {
                TextureChannel.Red or TextureChannel.Alpha => ahead.R[packet] - behind.R[packet],
                TextureChannel.Green => ahead.G[packet] - behind.G[packet],
                TextureChannel.Blue => ahead.B[packet] - behind.B[packet],
                _ => F.Fma(
                    F.Of(0.2126f),
                    ahead.R[packet] - behind.R[packet],
                    F.Fma(F.Of(0.7152f), ahead.G[packet] - behind.G[packet], F.Of(0.0722f) * (ahead.B[packet] - behind.B[packet]))),
            };
        }
    }
}
