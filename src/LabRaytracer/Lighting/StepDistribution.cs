namespace LabRaytracer;

/// <summary>Numbers drawn in proportion to the weights of steps of [0, 1), even inside of each step.</summary>
/// <remarks>Immutable, thread safe.</remarks>
internal sealed class StepDistribution
{
    private readonly double[] _edges;
    private readonly int[] _guide;

    /// <param name="weights">Weights of the steps, at least 0; at least one step.</param>
    public StepDistribution(ReadOnlySpan<double> weights)
    {
        _edges = new double[weights.Length + 1];
        for (int step = 0; step < weights.Length; step++)
        {
            _edges[step + 1] = _edges[step] + weights[step];
        }

        Total = _edges[^1];
        _guide = new int[Total > 0 ? weights.Length : 0];
        for (int step = 0; Total > 0 && step <= weights.Length; step++)
        {
            _edges[step] /= Total;
        }

        // Where the search for x starts: at the step that holds floor(x n) / n, so that it passes one edge on average.
        for (int step = 0, bucket = 0; bucket < _guide.Length; bucket++)
        {
            while (_edges[step + 1] <= (double)bucket / _guide.Length)
            {
                step++;
            }

            _guide[bucket] = step;
        }
    }

    /// <summary>Sum of the weights.</summary>
    public double Total { get; }

    /// <summary>Probability of a step.</summary>
    public double Share(int step) => _edges[step + 1] - _edges[step];

    /// <summary>The step that a number falls into; never one of weight 0.</summary>
    /// <param name="x">The number, [0, 1).</param>
    /// <param name="inside">Where inside of the step, [0, 1].</param>
    /// <param name="share">Probability of the step.</param>
    public int Find(double x, out double inside, out double share)
    {
        int step = _guide[(int)(x * _guide.Length)];
        while (_edges[step + 1] <= x)
        {
            step++;
        }

        share = _edges[step + 1] - _edges[step];
        inside = (x - _edges[step]) / share;
        return step;
    }
}
