using System.Runtime.CompilerServices;

namespace LabRaytracer;

/// <content>Both angles of a single point side by side: half the work of one after the other, the same bits as the general form.</content>
internal static partial class Elementary
{
    // Index: 4 for x < 0, 2 for z < 0, 1 for |x| > |z|.
    private static ReadOnlySpan<double> AzimuthStarts => [0, 0.25, 0.5, 0.25, 1, 0.75, 0.5, 0.75];

    private static ReadOnlySpan<double> AzimuthSigns => [0, -0.0, -0.0, 0, -0.0, 0, 0, -0.0];

    // Index: 2 for y > 0, 1 for |y| <= radius.
    private static ReadOnlySpan<double> HeightStarts => [0, 0.25, 0.5, 0.25];

    private static ReadOnlySpan<double> HeightSigns => [0, -0.0, -0.0, 0];

    /// <summary><see cref="SphereTurns{T}(T, T, T)"/> of one point.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    public static (double Azimuth, double Height) SphereTurns(double x, double y, double z)
    {
        double ax = Math.Abs(x), ay = Math.Abs(y), az = Math.Abs(z);
        double sum = ax + az;
        if (!(ax >= LeastOrdinary && az >= LeastOrdinary && sum + ay < MostOrdinary))
        {
            (Double1 azimuth, Double1 polar) = SphereTurnsRescaled(new Double1(x), new Double1(y), new Double1(z));
            return (azimuth.Value, polar.Value);
        }

        Double1 larger = Double1.Max(new(ax), new(az)), smaller = Double1.Min(new(ax), new(az)), height = new(ay);
        Double1 radius = Radius(smaller, larger, out Double1 error);
        Double1 low = Double1.LessOrEqual(height, radius);
        int octant = (Bit(x < 0) << 2) | (Bit(z < 0) << 1) | Bit(az < ax);
        int quadrant = (Bit(y > 0) << 1) | Bit(ay <= radius.Value);
        Double2 steep = Reduce(
            Double2.Pair(smaller, Double1.Min(height, radius)), Double2.Pair(larger, Double1.Max(height, radius)),
            out Double2 numerator, out Double2 denominator, out Double2 numeratorError, out Double2 denominatorError);
        Correct(steep, Double2.Pair(low, low), Double2.Pair(default, error), ref numeratorError, ref denominatorError);
        Double2 turns = AddAtanTurns(
            Double2.Pair(At(AzimuthStarts, octant), At(HeightStarts, quadrant)), Double2.Pair(At(AzimuthSigns, octant), At(HeightSigns, quadrant)),
            steep, numerator, denominator, numeratorError, denominatorError);
        double halfHeight = Double2.Get(turns, 1);
        return (Double1.Min(new(Double2.Get(turns, 0)), BelowOne<Double1>()).Value, halfHeight + halfHeight);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Bit(bool condition) => condition ? 1 : 0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Double1 At(ReadOnlySpan<double> table, int index) => new(table[index]);
}
