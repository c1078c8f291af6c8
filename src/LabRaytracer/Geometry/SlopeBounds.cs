namespace LabRaytracer;

/// <summary>Least and largest slopes of some rays of a pencil.</summary>
internal struct SlopeBounds
{
    /// <summary>More than any slope, sheared or not.</summary>
    public const float Above = 9;

    /// <summary>The least and the largest slope along x and along y.</summary>
    public float LowX, HighX, LowY, HighY;

    /// <summary>Bounds of no ray.</summary>
    public static SlopeBounds None => new() { LowX = Above, HighX = -Above, LowY = Above, HighY = -Above };

    /// <summary>Tells whether there is no ray.</summary>
    public readonly bool IsEmpty => LowX > HighX;

    /// <summary>Middle along x.</summary>
    public readonly double MiddleX => 0.5 * ((double)LowX + HighX);

    /// <summary>Middle along y.</summary>
    public readonly double MiddleY => 0.5 * ((double)LowY + HighY);

    /// <summary>Largest difference from the middle along x.</summary>
    public readonly double SpreadX => 0.5 * ((double)HighX - LowX);

    /// <summary>Largest difference from the middle along y.</summary>
    public readonly double SpreadY => 0.5 * ((double)HighY - LowY);

    /// <summary>Includes the bounds of more rays.</summary>
    public void Include(in SlopeBounds more)
    {
        (LowX, HighX) = (Math.Min(LowX, more.LowX), Math.Max(HighX, more.HighX));
        (LowY, HighY) = (Math.Min(LowY, more.LowY), Math.Max(HighY, more.HighY));
    }
}
