namespace LabRaytracer;

/// <summary>Tells hits from outside and from inside apart, for materials that differ on both sides.</summary>
internal sealed unsafe class SideSplit<R, F, I>
    where R : unmanaged, ILane<R, F, I>
    where F : unmanaged, ILane<F, F, I>
    where I : unmanaged, IIndexLane<I>
{
    /// <param name="memory">Owns the columns.</param>
    /// <param name="capacity">Most rays of a batch.</param>
    public SideSplit(LaneMemory memory, int capacity)
    {
        Outside = memory.Column<int>(capacity + R.Width, 1);
        Inside = memory.Column<int>(capacity + R.Width, 1);
    }

    /// <summary>Numbers of the rays that hit from outside, padded to whole groups of lanes.</summary>
    public int* Outside { get; }

    /// <summary>How many.</summary>
    public int OutsideCount { get; private set; }

    /// <summary>Numbers of the rays that hit from inside, padded to whole groups of lanes.</summary>
    public int* Inside { get; }

    /// <summary>How many.</summary>
    public int InsideCount { get; private set; }

    /// <summary>Splits a group.</summary>
    /// <param name="order">Numbers of its rays.</param>
    /// <param name="count">How many.</param>
    /// <param name="inside">Mask of hits from inside.</param>
    public void Run(int* order, int count, R* inside)
    {
        OutsideCount = InsideCount = 0;
        for (int packet = 0; packet * R.Width < count; packet++)
        {
            uint bits = R.Bits(inside[packet]);
            for (int lane = 0; lane < R.Width && (packet * R.Width) + lane < count; lane++)
            {
                int ray = order[(packet * R.Width) + lane];
                if ((bits >> lane & 1) != 0)
                {
                    Inside[InsideCount++] = ray;
                }
                else
                {
                    Outside[OutsideCount++] = ray;
                }
            }
        }

        Pad(Outside, OutsideCount);
        Pad(Inside, InsideCount);
    }

    private static void Pad(int* order, int count)
    {
        for (int pad = count; pad % R.Width != 0; pad++)
        {
            order[pad] = order[count - 1];
        }
    }
}
