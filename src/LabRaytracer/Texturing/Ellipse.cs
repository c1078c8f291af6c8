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

    /// <summary>Change of the middle of a row from row to row.</summary>
    public readonly float Slant;

    /// <summary>Weight lost per square texel from the middle of a row.</summary>
    public readonly float Fall;

    private readonly float _inverseSquareHeight;
    private readonly float _inverseFall;

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
        Slant = exy * _inverseSquareHeight;
        Fall = eyy / determinant;
        _inverseFall = determinant * _inverseSquareHeight;
    }

    /// <summary>Weight in the middle of a row; not above 0 where the row lies outside.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Middle(float dy) => MathF.FusedMultiplyAdd(-dy * dy, _inverseSquareHeight, 1);

    /// <summary>Half the width of a row with a given weight in the middle, texels.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float HalfWidth(float middle) => MathF.Sqrt(middle * _inverseFall);
}
