using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>Thresholds for dither without a pattern: pixels next to each other have very different ones, so that the grain is fine and has no direction.</summary>
/// <remarks>
/// <para>R. A. Ulichney, "The void-and-cluster method for dither array generation", 1993: pixels get their ranks one after the other, each the one that lies farthest from those that
/// have one, by the sum of Gaussians around them (standard deviation 1.5 pixels, the picture repeated on all sides). The first tenth is spread out from a seeded
/// random start until no pixel moves, and ranked backwards.</para>
/// <para>Sums are whole numbers and ties go to the first pixel: the same mask on every machine. Made once, when a picture first asks for it.</para>
/// </remarks>
internal sealed class BlueNoiseMask
{
    /// <summary>Rows and columns after which the thresholds repeat.</summary>
    public const int Side = 64;

    private const int Count = Side * Side;
    private const int Reach = 9;

    private static readonly Lazy<BlueNoiseMask> s_shared = new(() => new BlueNoiseMask());

    private readonly bool[] _isSet = new bool[Count];
    private readonly int[] _nearness = new int[Count];
    private readonly int[] _gaussian = Gaussian();
    private readonly int[] _ranks = new int[Count];

    private BlueNoiseMask()
    {
        SpreadOut();
        RankFirst();
        for (int rank = Count / 10; rank < Count; rank++)
        {
            int place = Void();
            Put(place, isSet: true);
            _ranks[place] = rank;
        }
    }

    /// <summary>The threshold of a pixel, in (0, 1): each of (k + 1/2) / 4096 once in 64 x 64 pixels.</summary>
    /// <param name="x">Column, at least 0.</param>
    /// <param name="y">Row, at least 0.</param>
    public static float Threshold(int x, int y) => (s_shared.Value._ranks[((y % Side) * Side) + (x % Side)] + 0.5f) / Count;

    /// <summary>exp(-(dx² + dy²) / (2 1.5²)) in units of 2^-20.</summary>
    private static int[] Gaussian()
    {
        int width = (2 * Reach) + 1;
        int[] table = new int[width * width];
        for (int i = 0; i < table.Length; i++)
        {
            int dx = (i % width) - Reach, dy = (i / width) - Reach;
            table[i] = (int)Math.Round((1 << 20) * PortablePower.Pow(Math.E, -((dx * dx) + (dy * dy)) / 4.5));
        }

        return table;
    }

    /// <summary>The first tenth of the pixels: at random, then the one in the tightest cluster moves into the largest void until that is where it came from.</summary>
    private void SpreadOut()
    {
        ulong state = 1;
        for (int set = 0; set < Count / 10;)
        {
            // The generator of L'Ecuyer's table, modulus 2^64.
            state = (state * 2862933555777941757) + 3037000493;
            int place = (int)(state >> 52);
            if (!_isSet[place])
            {
                Put(place, isSet: true);
                set++;
            }
        }

        int from, to;
        do
        {
            from = Cluster();
            Put(from, isSet: false);
            to = Void();
            Put(to, isSet: true);
        }
        while (from != to);
    }

    /// <summary>Ranks the pixels that are set, the one in the tightest cluster last, and leaves them set.</summary>
    private void RankFirst()
    {
        bool[] start = [.. _isSet];
        for (int rank = (Count / 10) - 1; rank >= 0; rank--)
        {
            int place = Cluster();
            Put(place, isSet: false);
            _ranks[place] = rank;
        }

        for (int place = 0; place < Count; place++)
        {
            if (start[place])
            {
                Put(place, isSet: true);
            }
        }
    }

    /// <summary>The set pixel with the most others near it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private int Cluster()
    {
        int best = -1;
        for (int place = 0; place < Count; place++)
        {
            best = _isSet[place] && (best < 0 || _nearness[place] > _nearness[best]) ? place : best;
        }

        return best;
    }

    /// <summary>The pixel that is not set with the fewest others near it.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private int Void()
    {
        int best = -1;
        for (int place = 0; place < Count; place++)
        {
            best = !_isSet[place] && (best < 0 || _nearness[place] < _nearness[best]) ? place : best;
        }

        return best;
    }

    /// <summary>Sets or clears a pixel.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void Put(int place, bool isSet)
    {
        _isSet[place] = isSet;
        int width = (2 * Reach) + 1, sign = isSet ? 1 : -1;
        for (int i = 0; i < _gaussian.Length; i++)
        {
            int x = (place + (i % width) - Reach) & (Side - 1), y = ((place / Side) + (i / width) - Reach) & (Side - 1);
            _nearness[(y * Side) + x] += sign * _gaussian[i];
        }
    }
}
