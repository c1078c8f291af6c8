namespace LabRaytracer;

/// <summary>How a cell texture measures distance.</summary>
public enum WorleyMetric
{
    /// <summary>sqrt(dx² + dy² + dz²): round cells.</summary>
    Euclidean,

    /// <summary>|dx| + |dy| + |dz|: diamonds.</summary>
    Manhattan,

    /// <summary>The largest of |dx|, |dy|, |dz|: squares.</summary>
    Chebyshev,
}
