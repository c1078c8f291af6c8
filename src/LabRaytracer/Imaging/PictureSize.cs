namespace LabRaytracer;

/// <summary>The sides a picture may have.</summary>
internal static class PictureSize
{
    /// <summary>Largest side, pixels.</summary>
    public const int MaxSide = 1 << 20;

    /// <summary>Throws unless both sides are in [1, 1048576] and the pixels can be kept in one array.</summary>
    public static void Check(int width, int height)
    {
        CheckSide(width, nameof(width));
        CheckSide(height, nameof(height));
        if ((long)width * height > Array.MaxLength / 4)
        {
            throw new ArgumentOutOfRangeException(
                nameof(height),
                $"A picture of {width} x {height} pixels is too large: at most {Array.MaxLength / 4} pixels are allowed; choose a smaller size.");
        }
    }

    private static void CheckSide(int side, string name)
    {
        if (side is < 1 or > MaxSide)
        {
            throw new ArgumentOutOfRangeException(name, side, $"The {name} of a picture must be in [1, {MaxSide}] pixels.");
        }
    }
}
