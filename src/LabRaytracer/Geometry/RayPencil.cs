namespace LabRaytracer;

/// <summary>A pencil of rays: lines through one point, the apex, which are camera rays through the eye, or shadow rays through a lamp.</summary>
/// <remarks>
/// Axes are turned cyclically so that every direction is largest along z, and z points from the apex to where the rays are. A line is then apex + w (x, y, 1)
/// with slopes x and y in [-1, 1], which all lines of a small part of a picture share but for a little: they are kept as a middle and small differences.
/// </remarks>
internal struct RayPencil
{
    /// <summary>More than this is not sheared.</summary>
    public const double LargestShear = 4;

    /// <summary>How many rays are on.</summary>
    public int Rays;

    /// <summary>The apex, with turned axes.</summary>
    public double ApexX, ApexY, ApexZ;

    /// <summary>Multiple of a line's slope along x that is subtracted from its slope along y, [-<see cref="LargestShear"/>, <see cref="LargestShear"/>]: pencils are seldom upright.</summary>
    public double Shear;

    /// <summary>Middle of the slopes, sheared.</summary>
    public double MiddleX, MiddleY;

    /// <summary>Largest differences of slopes from the middle.</summary>
    public double SpreadX, SpreadY;

    /// <summary>By how much bounds of slopes in floats may be too narrow: slopes are rounded for them, and the middle is.</summary>
    public double SlopeError;

    /// <summary>Which axis (0, 1, 2) has become z.</summary>
    public int Axis;

    /// <summary>-1 where z is reversed, else 1.</summary>
    public double Sign;

    /// <summary>No coordinate of rays and mesh, from the origin or from the apex, is larger in magnitude; nor the sum of a vertex's three and a ray's three.</summary>
    public double Size;

    /// <summary>No ray starts farther from the apex along z; 0 where rays start there.</summary>
    public double Way;

    /// <summary>No line passes the apex farther away, as the sum of three coordinates.</summary>
    public double Beside;

    /// <summary>How far beside a line the test may see points, along x and along y.</summary>
    public double TestError;

    /// <summary>The same in sheared axes.</summary>
    public double SlopeMargin;

    /// <summary>How far a ray's limit along z may differ from the place of its origin.</summary>
    public double LimitError;

    /// <summary>What is nearer to the apex along z, or behind it, is not certain to be hit.</summary>
    public double Nearest;
}
