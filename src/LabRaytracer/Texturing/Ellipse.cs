using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The weights of texels around a place: 1 - q inside an ellipse, where q grows from 0 at its centre to 1 at its edge.</summary>
/// <remarks>
/// The ellipse has the covariance of the parallelogram of the footprint, (a a' + b b') / 12 for its sides a and b, and a little more in every direction: so much that
/// it is at least that of bilinear lookup, 1/6 of a square texel, and always holds a texel. The weight has a sixth of the square of its edge's distance for variance.
/// </remarks>
internal readonly struct Ellipse
{
    private const float LeastVariance = 1f / 6;

    /// <summary>Square of the edge's distance in units of the variance.</summary>
    private const float Edge = 6;

    /// <summary>Half the height, texels.</summary>
    public readonly float Height;

    /// <summary>Weight lost per square texel from the middle of a row.</summary>
    public readonly float Fall;

    private readonly float _inverseSquareHeight;
    private readonly float _inverseFall;
    private readonly float _slant;

    /// <param name="xx">Sum of the squares of the sides' components along a row, square texels.</param>
    /// <param name="xy">Sum of the products of their components.</param>
    /// <param name="yy">Sum of the squares of their components across.</param>
    /// <param name="shorter">Square of the shorter side, square texels.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Ellipse(float xx, float xy, float yy, float shorter)
    {
        float more = Edge * (LeastVariance - (MathF.Min(shorter, 1) / 12));
        float exx = MathF.FusedMultiplyAdd(xx, Edge / 12, more), exy = xy * (Edge / 12), eyy = MathF.FusedMultiplyAdd(yy, Edge / 12, more);

        // Never flatter than the least, whatever cancels.
        float determinant = MathF.Max(MathF.FusedMultiplyAdd(exx, eyy, -(exy * exy)), Edge * LeastVariance * MathF.Max(exx, eyy));
        Height = MathF.Sqrt(eyy);
        _inverseSquareHeight = 1 / eyy;
        _slant = exy * _inverseSquareHeight;
        Fall = eyy / determinant;
        _inverseFall = determinant * _inverseSquareHeight;
    }

    /// <summary>One row.</summary>
    /// <param name="dy">The row, from the centre.</param>
    /// <param name="centerX">Centre of the ellipse.</param>
    /// <param name="center">Middle of the row.</param>
    /// <param name="from">First texel.</param>
    /// <param name="to">Last texel; before the first one if the row lies outside.</param>
    /// <returns>Weight in the middle of the row.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Row(float dy, float centerX, out float center, out int from, out int to)
    {
        float middle = MathF.FusedMultiplyAdd(-dy * dy, _inverseSquareHeight, 1);
        middle = middle > 0 ? middle : 0;
        float half = MathF.Sqrt(middle * _inverseFall);
        center = MathF.FusedMultiplyAdd(_slant, dy, centerX);

        // A few hundred at most: no need to look whether they fit an integer.
        from = float.ConvertToIntegerNative<int>(MathF.Ceiling(center - half));
        to = float.ConvertToIntegerNative<int>(MathF.Floor(center + half));
        return middle;
    }
}
