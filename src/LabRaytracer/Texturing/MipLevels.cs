using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Sizes of levels of a pyramid and where they lie, a level a lane.</summary>
internal static unsafe class MipLevels
{
    /// <summary>Looks the numbers up; mostly one level is that of all lanes, and nothing is gathered.</summary>
    /// <param name="pyramid">The levels.</param>
    /// <param name="level">A level a lane.</param>
    /// <param name="width">Columns.</param>
    /// <param name="height">Rows.</param>
    /// <param name="start">The texel at which the level starts.</param>
    /// <param name="stride">From the first texel of a row to that of the next one.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Find<I>(MipPyramid pyramid, I level, out I width, out I height, out I start, out I stride)
        where I : unmanaged, IIndexLane<I>
    {
        int one = I.Get(level, 0);
        if (I.AllEqual(level, one))
        {
            width = I.Of(pyramid.Widths[one]);
            height = I.Of(pyramid.Heights[one]);
            start = I.Of(pyramid.Starts[one]);
            stride = I.Of(pyramid.Strides[one]);
            return;
        }

        width = I.Gather(pyramid.Widths, level);
        height = I.Gather(pyramid.Heights, level);
        start = I.Gather(pyramid.Starts, level);
        stride = I.Gather(pyramid.Strides, level);
    }
}
