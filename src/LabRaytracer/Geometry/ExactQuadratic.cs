namespace LabRaytracer;

/// <summary>The roots of a s² + 2 b s + c = 0 with a above 0, known by exact comparisons.</summary>
/// <param name="a">Coefficient of s², above 0.</param>
/// <param name="b">Half the coefficient of s.</param>
/// <param name="c">The rest.</param>
internal readonly struct ExactQuadratic(ExactNumber a, ExactNumber b, ExactNumber c)
{
    /// <summary>Tells whether there are real roots.</summary>
    public bool HasRoots => ((b * b) - (a * c)).Sign >= 0;

    /// <summary>The sign of a root minus (numerator / denominator).</summary>
    /// <param name="isFar">True for the larger root.</param>
    /// <param name="numerator">Numerator.</param>
    /// <param name="denominator">Denominator, not 0.</param>
    /// <remarks>
    /// With f the polynomial and g half its derivative: f &lt; 0 between the roots; else the sign of g tells on which side of both the number lies, and f = 0 which it is.
    /// </remarks>
    public int Compare(bool isFar, ExactNumber numerator, ExactNumber denominator)
    {
        int f = ((a * numerator * numerator) + ((b + b) * numerator * denominator) + (c * denominator * denominator)).Sign;
        int g = ((a * numerator) + (b * denominator)).Sign * denominator.Sign;
        int between = isFar ? 1 : -1;
        return f < 0 ? between : f == 0 && g * between >= 0 ? 0 : -g;
    }

    /// <summary>A root above 0, rounded correctly.</summary>
    /// <param name="isFar">True for the larger root.</param>
    public double Nearest(bool isFar)
    {
        ExactQuadratic self = this;
        return ExactNumber.Nearest(number => self.Compare(isFar, number, 1));
    }
}
