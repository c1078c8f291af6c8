using System.Runtime.InteropServices;

namespace LabRaytracer;

/// <summary>Levels of a pyramid once more, those that are grey, with one number a texel instead of four: what footprints over many rows wait for is the memory.</summary>
/// <remarks>Texels have the places that they have in the pyramid, with the margin. Memory of levels that are not grey is not touched. Thread safe.</remarks>
internal sealed unsafe class GreyLevels
{
    private readonly MipPyramid _pyramid;
    private readonly Lock _copying = new();
    private uint _known, _grey;

    /// <param name="pyramid">The levels.</param>
    /// <param name="texels">Texels of all of them, with what lies beside.</param>
    public GreyLevels(MipPyramid pyramid, long texels)
    {
        _pyramid = pyramid;

        // Not cleared: pages that no level is written to take no memory.
        Texels = (float*)NativeMemory.AlignedAlloc((nuint)Math.Max(1, texels) * sizeof(float), 64);
    }

    ~GreyLevels() => NativeMemory.AlignedFree(Texels);

    /// <summary>The texels.</summary>
    public float* Texels { get; }

    /// <summary>Tells whether a level is here: it is grey, and somebody has asked for it.</summary>
    /// <param name="level">The level.</param>
    public bool Has(int level) => (Volatile.Read(ref _grey) >> level & 1) != 0;

    /// <summary>Finds out which of some levels are grey; they must be there in the pyramid.</summary>
    /// <param name="first">The first level.</param>
    /// <param name="last">The last level.</param>
    public void Require(int first, int last)
    {
        uint asked = (2u << last) - (1u << first);
        if ((Volatile.Read(ref _known) & asked) == asked)
        {
            return;
        }

        lock (_copying)
        {
            for (int level = first; level <= last; level++)
            {
                uint bit = 1u << level;
                if ((_known & bit) == 0)
                {
                    Volatile.Write(ref _grey, _grey | (Copy(level) ? bit : 0));
                    Volatile.Write(ref _known, _known | bit);
                }
            }
        }
    }

    /// <summary>Copies a level up to the first texel that is not grey.</summary>
    /// <returns>False if there is one.</returns>
    private bool Copy(int level)
    {
        int margin = _pyramid.Margin, width = margin + _pyramid.Widths[level] + Math.Max(margin, 1);
        for (int y = -margin; y < _pyramid.Heights[level] + margin; y++)
        {
            long start = _pyramid.Starts[level] + ((long)y * _pyramid.Strides[level]) - margin;
            float* from = _pyramid.Texels + (MipPyramid.Channels * start), to = Texels + start;
            for (int x = 0; x < width; x++)
            {
                if (from[0] != from[1] || from[0] != from[2])
                {
                    return false;
                }

                to[x] = from[0];
                from += MipPyramid.Channels;
            }
        }

        return true;
    }
}
