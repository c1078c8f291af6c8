using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <summary>The weights of texels around a place: 1 - q inside an ellipse, where q grows from 0 at its centre to 1 at its edge.</summary>
/// <remarks>
/// The ellipse has the covariance of the parallelogram of the footprint, (a a' + b b') / 12 for its sides a and b, and that of <see cref="Blur"/> texels more,
/// so that it always holds some. The weight has a sixth of the square of its edge's distance for variance in every direction.
/// </remarks>
internal readonly struct Ellipse
{
    /// <summary>Variance of the weights over a point, square texels.</summary>
    public const float Blur = 1f / 6;

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
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Ellipse(float xx, float xy, float yy)
    {
        float exx = MathF.FusedMultiplyAdd(xx, Edge / 12, Edge * Blur), exy = xy * (Edge / 12), eyy = MathF.FusedMultiplyAdd(yy, Edge / 12, Edge * Blur);

        // Never flatter than the blur alone, whatever cancels.
        float determinant = MathF.Max(MathF.FusedMultiplyAdd(exx, eyy, -(exy * exy)), Edge * Blur * MathF.Max(exx, eyy));
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
        float middle = MathF.Max(MathF.FusedMultiplyAdd(-dy * dy, _inverseSquareHeight, 1), 0), half = MathF.Sqrt(middle * _inverseFall);
        center = MathF.FusedMultiplyAdd(_slant, dy, centerX);
        from = (int)MathF.Ceiling(center - half);
        to = (int)MathF.Floor(center + half);
        return middle;
    }
}
